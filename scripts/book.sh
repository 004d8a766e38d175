#!/usr/bin/env bash
# Builds the book from the pages of the repository.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/book.sh [--out DIR] [--open] [--help]

Builds the book of docs/SUMMARY.md as HTML, in seconds, by the mdBook that `scripts/setup.sh --book` installs, or else the
one on the PATH. The book has the pages of docs/ and those at the root of the repository.

  --out DIR  the folder of the book, which is replaced (default: out/book); it must be new, empty, or a book
  --open     open the book in a browser
  --help     this text

Exit codes: 0 the book is built; 1 mdBook failed or warned; 2 bad usage or no mdBook.
USAGE
}

fail() {
    local code=$1
    shift
    printf 'book: %s\n' "$*" >&2
    exit "$code"
}

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=out/book open=()
while (($# > 0)); do
    case $1 in
        --out)
            (($# > 1)) || fail 2 "found --out without a folder"
            out=$2
            shift
            ;;
        --open) open=(--open) ;;
        -h | --help)
            usage
            exit 0
            ;;
        *) fail 2 "found \`$1\`, expected --out DIR, --open or --help" ;;
    esac
    shift
done

tools=$("$root/scripts/setup.sh" --where-book 2>/dev/null) && PATH=$tools:$PATH
command -v mdbook >/dev/null || fail 2 "found no mdbook; \`scripts/setup.sh --book\` installs it"
if [[ -e $out ]] && ! grep -qs "generated using mdBook" "$out/index.html" && [[ -n $(ls -A "$out") ]]; then
    fail 2 "--out $out: found a folder that is no book, expected a new or empty one, or a book to replace"
fi
mkdir -p "$out"
out=$(cd "$out" && pwd)

# mdBook copies every file of its source folder, so the folder has only what belongs to the book.
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT
mkdir -p "$stage/src"
cp "$root/docs/book.toml" "$stage/"
cp "$root"/*.md "$root"/LICENSE "$root"/CITATION.cff "$stage/src/"
cp -r "$root/docs" "$stage/src/docs"
# The list of chapters is in docs/, where its links are those of the other pages; mdBook wants it at the root.
sed -E 's#\]\(#](docs/#; s#\]\(docs/\.\./#](#; s#\]\(docs/\)#]()#' "$root/docs/SUMMARY.md" >"$stage/src/SUMMARY.md"
rm "$stage/src/docs/SUMMARY.md" "$stage/src/docs/book.toml"

said=$(mdbook build --dest-dir "$out" "${open[@]}" "$stage" 2>&1) || fail 1 "$said"
if grep -E '^ *(WARN|ERROR)' <<<"$said" >&2; then
    fail 1 "mdBook warned; see above"
fi
printf 'wrote %s\n' "$out/index.html"
