//! Planted mistakes in a chapter and in a built book; each must be found.

use std::fs;

use libtest_mimic::{Failed, Trial};

use super::{built, chapter};

/// A chapter whose files, folders and exit codes are right.
const CHAPTER: &str = "
File `greeting.txt`:

```text
hello
```

```console
$ mkdir inner; cd inner
$ cat ../greeting.txt \\
> | tr h H
Hello
$ printf 'took 3 s\\nand\\nmore\\n'
took [..] s
...
$ photoncube list pentium
error: there is no machine `pentium`[..]
$ echo $?
2
```
";

/// What `follow` says of `CHAPTER` with one text replaced.
fn said(from: &str, to: &str) -> Result<String, Failed> {
    let changed = CHAPTER.replacen(from, to, 1);
    if changed == CHAPTER && from != to {
        return Err(format!("nothing to replace: {from}").into());
    }
    let folder = tempfile::tempdir()?;
    let page = folder.path().join("page.md");
    fs::write(&page, changed)?;
    Ok(chapter::follow(&page, false).err().unwrap_or_default())
}

fn expect(from: &str, to: &str, expected: &str) -> Result<(), Failed> {
    let said = said(from, to)?;
    match said.contains(expected) {
        true => Ok(()),
        false => Err(format!("{from} -> {to}: expected `{expected}`, found `{said}`").into()),
    }
}

fn a_right_chapter_passes() -> Result<(), Failed> {
    match said("", "")?.as_str() {
        "" => Ok(()),
        said => Err(said.into()),
    }
}

fn a_wrong_chapter_is_found() -> Result<(), Failed> {
    for (from, to, expected) in [
        ("\nHello", "\nHallo", "line 10: `cat"),
        (
            "hello\n```",
            "bye\n```",
            "printed\nbye\n--- the page promises\nHello\n",
        ),
        ("took [..] s", "took [..] min", "line 13: `printf"),
        ("...\n", "", "line 13: `printf"),
        ("...\n", "and\n", "and\nmore\n"),
        ("\n2\n", "\n1\n", "line 18: `echo $?` printed\n2\n"),
        (
            "echo $?\n2",
            "echo done\ndone",
            "exit code 2, and printed\nerror:",
        ),
        ("$ printf", "$ false | printf", "exit code 1, and printed"),
        ("cd inner", "exit 0", "ended the session"),
        ("```console", "```sh", "found a block `sh`"),
        // The block is then an example, and `cat` finds no file.
        ("File `", "A file `", "No such file"),
    ] {
        expect(from, to, expected)?;
    }
    Ok(())
}

fn a_dead_link_is_found() -> Result<(), Failed> {
    let folder = tempfile::tempdir()?;
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text);
    write(
        "a.html",
        "<a href=\"b.html#part\">b</a> <a href=\"https://example.org\">web</a>",
    )?;
    write(
        "b.html",
        "<h2 id=\"part\">part</h2> <img src=\"gone.png\"> <a href=\"#gone\">g</a> <a href=\"c.html\">c</a>",
    )?;
    let dead = built::dead_links(folder.path());
    let expected = ["b.html: #gone", "b.html: c.html", "b.html: gone.png"];
    match dead == expected {
        true => Ok(()),
        false => Err(format!("found {dead:?}, expected {expected:?}").into()),
    }
}

pub fn trials() -> Vec<Trial> {
    vec![
        Trial::test("a_right_chapter_passes", a_right_chapter_passes),
        Trial::test("a_wrong_chapter_is_found", a_wrong_chapter_is_found),
        Trial::test("a_dead_link_is_found", a_dead_link_is_found),
    ]
}
