//! An SVG picture that is drawn box by box, and knows where a text is wider than its place.

use anyhow::{Result, bail};
use maud::{Markup, PreEscaped, html};

use crate::plots::palette;

/// A place on a canvas: left, top, width, height.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The left edge.
    pub x: i32,
    /// The upper edge.
    pub y: i32,
    /// From the left edge to the right one.
    pub width: i32,
    /// From the upper edge to the lower one.
    pub height: i32,
}

impl Place {
    /// The place with this left upper corner and this size.
    pub const fn new(x: i32, y: i32, width: i32, height: i32) -> Self {
        Self {
            x,
            y,
            width,
            height,
        }
    }

    /// The right edge.
    pub fn right(self) -> i32 {
        self.x + self.width
    }

    /// The lower edge.
    pub fn bottom(self) -> i32 {
        self.y + self.height
    }

    /// The middle.
    pub fn middle(self) -> [i32; 2] {
        [self.x + self.width / 2, self.y + self.height / 2]
    }
}

/// What a box stands for, which decides its colours.
#[derive(Copy, Clone, Debug)]
pub enum Kind {
    /// A part that is neither of the others.
    Plain,
    /// What computes.
    Unit,
    /// What stores a word.
    Register,
}

impl Kind {
    fn class(self) -> &'static str {
        match self {
            Self::Plain => "box",
            Self::Unit => "unit",
            Self::Register => "register",
        }
    }
}

/// The size and the font of a text.
#[derive(Copy, Clone, Debug)]
pub enum Face {
    /// The title of a part of the picture.
    Head,
    /// A label.
    Label,
    /// A remark.
    Note,
    /// A name or a formula of the machine.
    Code,
}

impl Face {
    fn class(self) -> &'static str {
        match self {
            Self::Head => "head",
            Self::Label => "label",
            Self::Note => "note",
            Self::Code => "code",
        }
    }

    /// The mean width of a character in tenths of a pixel, for a wide font.
    fn tenths(self) -> usize {
        match self {
            Self::Head => 92,
            Self::Label => 72,
            Self::Note => 60,
            Self::Code => 67,
        }
    }
}

/// A picture.
pub struct Canvas {
    size: [i32; 2],
    title: String,
    description: String,
    /// Where the coordinates that are given begin.
    origin: [i32; 2],
    shapes: Vec<Markup>,
    /// The texts that are wider than their places.
    tight: Vec<String>,
}

/// The distance of the lines of a text.
const LINE: i32 = 16;
/// The distance of a text's base line from the middle of its height.
const BASE: i32 = 4;

impl Canvas {
    /// An empty picture of that size, with a title and a description for those who do not see it.
    pub fn new(size: [i32; 2], title: &str, description: &str) -> Self {
        Self {
            size,
            title: title.to_owned(),
            description: description.to_owned(),
            origin: [0, 0],
            shapes: Vec::new(),
            tight: Vec::new(),
        }
    }

    /// Draws a part whose own coordinates begin at that place.
    pub fn part<T>(&mut self, at: [i32; 2], draw: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.origin;
        self.origin = [outer[0] + at[0], outer[1] + at[1]];
        self.shapes.push(PreEscaped(format!(
            "<g transform=\"translate({} {})\">",
            at[0], at[1]
        )));
        let drawn = draw(self);
        self.shapes.push(PreEscaped("</g>".to_owned()));
        self.origin = outer;
        drawn
    }

    /// A box.
    pub fn rectangle(&mut self, kind: Kind, place: Place) {
        self.within(place, "a box");
        let corner = (place.width / 4).min(4);
        self.shapes.push(html! {
            rect class=(kind.class()) x=(place.x) y=(place.y) width=(place.width) height=(place.height) rx=(corner) {}
        });
    }

    /// A box with lines of text in its middle.
    pub fn labelled(&mut self, kind: Kind, place: Place, lines: &[(Face, &str)]) {
        self.rectangle(kind, place);
        let needed = LINE * lines.len() as i32;
        if needed > place.height {
            let first = lines.first().map_or("", |(_, line)| line);
            self.tight.push(format!(
                "the lines from `{first}` on need {needed} pixels and have {}",
                place.height
            ));
        }
        let [_, middle] = place.middle();
        let first = middle + BASE - LINE * (lines.len() as i32 - 1) / 2;
        for (index, (face, line)) in lines.iter().enumerate() {
            self.centred(
                *face,
                [place.x, first + LINE * index as i32],
                place.width,
                line,
            );
        }
    }

    /// A text from the left, in a place of that width.
    pub fn text(&mut self, face: Face, at: [i32; 2], width: i32, text: &str) {
        self.put(face, at, width, text, false);
    }

    /// Lines of text from the left, one below the other.
    pub fn lines(&mut self, face: Face, [x, y]: [i32; 2], width: i32, lines: &[String]) {
        for (index, line) in lines.iter().enumerate() {
            self.text(face, [x, y + LINE * index as i32], width, line);
        }
    }

    /// A text in the middle of a place of that width.
    pub fn centred(&mut self, face: Face, at: [i32; 2], width: i32, text: &str) {
        self.put(face, at, width, text, true);
    }

    fn put(&mut self, face: Face, [x, y]: [i32; 2], width: i32, text: &str, centred: bool) {
        let needed = (text.chars().count() * face.tenths()).div_ceil(10) as i32;
        if needed > width {
            self.tight
                .push(format!("`{text}` needs {needed} pixels and has {width}"));
        }
        self.within(Place::new(x, y - LINE + BASE, width, LINE), text);
        let x = if centred { x + width / 2 } else { x };
        let anchor = if centred { "middle" } else { "start" };
        self.shapes.push(html! {
            text class=(face.class()) x=(x) y=(y) text-anchor=(anchor) { (text) }
        });
    }

    /// Notes what is outside of the picture.
    fn within(&mut self, place: Place, what: &str) {
        let [left, top] = [self.origin[0] + place.x, self.origin[1] + place.y];
        let [right, bottom] = [left + place.width, top + place.height];
        if left < 0 || top < 0 || right > self.size[0] || bottom > self.size[1] {
            let [width, height] = self.size;
            self.tight.push(format!(
                "{what} at {left}, {top} to {right}, {bottom} is outside of {width} x {height}"
            ));
        }
    }

    /// A line without a tip. The class is that of an axis, or `wire`.
    pub fn line(&mut self, class: &str, path: &str) {
        self.shapes
            .push(html! { path class={ "line " (class) } d=(path) {} });
    }

    /// A line with a tip at its end.
    pub fn arrow(&mut self, path: &str) {
        self.shapes
            .push(html! { path class="line wire" marker-end="url(#tip)" d=(path) {} });
    }

    /// A line with a tip at both ends.
    pub fn both_ways(&mut self, path: &str) {
        self.shapes.push(html! {
            path class="line wire" marker-start="url(#tip)" marker-end="url(#tip)" d=(path) {}
        });
    }

    /// The SVG text.
    ///
    /// # Errors
    /// A text is wider than its place, or something is outside of the picture.
    pub fn finish(self) -> Result<String> {
        if !self.tight.is_empty() {
            bail!("picture `{}`: {}", self.title, self.tight.join("; "));
        }
        let [width, height] = self.size;
        let mut text = html! {
            style { (PreEscaped(style())) }
            defs {
                marker #tip viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto-start-reverse" {
                    path class="tip" d="M0 0 L8 4 L0 8 z" {}
                }
            }
            rect class="paper" x="1" y="1" width=(width - 2) height=(height - 2) rx="8" {}
        }
        .into_string();
        text = text.replace("><", ">\n<");
        for shape in &self.shapes {
            text += "\n";
            text += &shape.0;
        }
        Ok(svg(self.size, &self.title, &self.description, &text))
    }
}

/// An SVG picture of these shapes.
pub fn svg([width, height]: [i32; 2], title: &str, description: &str, shapes: &str) -> String {
    let title = html! { title #title { (title) } }.into_string();
    let description = html! { desc #desc { (description) } }.into_string();
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         role=\"img\" aria-labelledby=\"title desc\" font-family=\"sans-serif\">\n{title}\n{description}\n{shapes}\n</svg>\n"
    )
}

/// The styles of all classes, in the colours of light and dark pages.
fn style() -> String {
    format!(
        ".head{{font-size:15px;font-weight:bold}}.label{{font-size:13px}}.note{{font-size:11px}}\
         .code{{font-size:11px;font-family:monospace}}\
         .line{{fill:none;stroke-width:1.4}}.x,.y,.z,.w{{stroke-width:2}}\
         .box,.unit,.register{{stroke-width:1.2}}.unit,.register{{fill-opacity:.16}}{}\
         @media (prefers-color-scheme:dark){{{}}}",
        colours(&palette::LIGHT),
        colours(&palette::DARK)
    )
}

fn colours(set: &palette::Set) -> String {
    let [paper, ink, faint, first, second, third] = [
        set.paper, set.ink, set.faint, set.first, set.second, set.third,
    ]
    .map(palette::css);
    format!(
        ".paper{{fill:{paper};stroke:{faint}}}text,.tip{{fill:{ink}}}.wire,.w{{stroke:{ink}}}.box{{fill:{paper};stroke:{ink}}}\
         .unit{{fill:{second};stroke:{second}}}.register{{fill:{first};stroke:{first}}}.x{{stroke:{second}}}.y{{stroke:{third}}}\
         .z{{stroke:{first}}}"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn canvas() -> Canvas {
        Canvas::new([100, 50], "a < b", "in words")
    }

    #[test]
    fn a_text_wider_than_its_place_is_refused() {
        let mut picture = canvas();
        picture.labelled(
            Kind::Plain,
            Place::new(10, 10, 40, 30),
            &[(Face::Code, "radius_sq")],
        );
        let said = picture.finish().unwrap_err().to_string();
        assert_eq!(
            said,
            "picture `a < b`: `radius_sq` needs 61 pixels and has 40"
        );
    }

    #[test]
    fn what_is_outside_of_the_picture_is_refused() {
        let mut picture = canvas();
        picture.part([60, 0], |picture| {
            picture.rectangle(Kind::Unit, Place::new(10, 10, 40, 30));
        });
        let said = picture.finish().unwrap_err().to_string();
        assert!(
            said.contains("a box at 70, 10 to 110, 40 is outside of 100 x 50"),
            "{said}"
        );
    }

    #[test]
    fn a_picture_has_title_description_and_the_colours_of_both_themes() {
        let mut picture = canvas();
        picture.labelled(
            Kind::Register,
            Place::new(10, 10, 80, 30),
            &[(Face::Label, "q & r")],
        );
        let text = picture.finish().unwrap();
        assert!(
            text.contains("<title id=\"title\">a &lt; b</title>"),
            "{text}"
        );
        assert!(text.contains("<desc id=\"desc\">in words</desc>"));
        assert!(text.contains("q &amp; r"));
        for set in [palette::LIGHT, palette::DARK] {
            assert!(text.contains(&palette::css(set.first)));
        }
    }
}
