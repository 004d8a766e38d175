//! Timing diagrams: WaveJSON, the format of WaveDrom, and its picture.

use std::ops::Range;

use anyhow::{Context, Result};
use plotters::style::RGBColor;
use serde_json::{Value, json};
use wavedrom::{Color, Figure, options::RenderOptions};

use super::canvas;
use crate::plots::palette::{self, DARK, LIGHT};

/// The values of a signal, clock by clock.
pub struct Signal {
    /// The name of the port, or of a field of it.
    pub name: String,
    /// The stream to which it belongs.
    pub group: String,
    /// The value in each clock; `None` where its stream shows no word, so that it means nothing.
    pub values: Vec<Option<u64>>,
    /// Whether it has one bit, and so a level in the place of a number.
    pub is_level: bool,
    /// The clocks behind a transfer, in which a word begins even if it is equal to the one before.
    pub begins: Vec<bool>,
}

/// A timing diagram.
pub struct Diagram {
    /// What it shows, in a line.
    pub title: String,
    /// The number of clocks.
    pub clocks: usize,
    /// The signals from the top down; those of a stream stand together.
    pub signals: Vec<Signal>,
}

/// The equal clocks that may be shown before a gap, the best number first; one more is shown behind it.
const BEFORE_GAP: [usize; 3] = [2, 1, 3];

/// Equal clocks, of which those in the middle may be left out.
#[derive(Clone)]
struct Run {
    clocks: Range<usize>,
    /// The clocks that are shown before the gap.
    before: usize,
}

/// The columns of some runs. A gap stands for at least two clocks.
fn columns_of(runs: &[Run]) -> Vec<Option<usize>> {
    let mut columns = Vec::new();
    for Run { clocks, before } in runs {
        let shown = before + 1;
        if clocks.len() >= shown + 2 {
            columns.extend(clocks.clone().take(*before).map(Some));
            columns.extend([None, clocks.clone().last()]);
        } else {
            columns.extend(clocks.clone().map(Some));
        }
    }
    columns
}

impl Signal {
    /// Whether a clock shows what the clock before shows.
    fn goes_on(&self, clock: usize) -> bool {
        let begins = !self.is_level && self.begins[clock] && self.values[clock].is_some();
        clock > 0 && self.values[clock] == self.values[clock - 1] && !begins
    }

    /// The WaveJSON of the signal in these columns: a clock, or a gap.
    fn wave(&self, columns: &[Option<usize>]) -> String {
        let (mut wave, mut data) = (String::new(), Vec::new());
        for column in columns {
            let Some(clock) = *column else {
                wave.push('|');
                continue;
            };
            wave.push(match self.values[clock] {
                _ if self.goes_on(clock) => '.',
                None => 'x',
                Some(0) if self.is_level => '0',
                Some(_) if self.is_level => '1',
                Some(value) => {
                    data.push(value.to_string());
                    '='
                }
            });
        }
        line(&self.name, &wave, &data)
    }
}

/// A signal as WaveJSON, the name first.
fn line(name: &str, wave: &str, data: &[String]) -> String {
    let [name, wave] = [name, wave].map(Value::from);
    match data {
        [] => format!("{{ \"name\": {name}, \"wave\": {wave} }}"),
        data => format!(
            "{{ \"name\": {name}, \"wave\": {wave}, \"data\": {} }}",
            json!(data)
        ),
    }
}

impl Diagram {
    /// The clocks in columns. Where nothing changes for long, a gap stands for the clocks in the middle. A gap is where it covers the
    /// fewest numbers.
    fn columns(&self) -> Vec<Option<usize>> {
        let rests = |clock: usize| self.signals.iter().all(|signal| signal.goes_on(clock));
        let starts: Vec<_> = (0..self.clocks).filter(|&clock| !rests(clock)).collect();
        let ends = starts.iter().skip(1).copied().chain([self.clocks]);
        // From each clock in which something changes to the next, with the clocks in front of a gap.
        let mut runs: Vec<Run> = starts
            .iter()
            .zip(ends)
            .map(|(&start, end)| Run {
                clocks: start..end,
                before: BEFORE_GAP[0],
            })
            .collect();
        for index in 0..runs.len() {
            let covered = |before: &usize| {
                let mut tried = runs.clone();
                tried[index].before = *before;
                self.covered(&columns_of(&tried))
            };
            let best = BEFORE_GAP.into_iter().min_by_key(covered);
            runs[index].before = best.unwrap_or(BEFORE_GAP[0]);
        }
        columns_of(&runs)
    }

    /// The numbers that gaps cover: those in whose middle a gap is.
    fn covered(&self, columns: &[Option<usize>]) -> usize {
        let buses = self.signals.iter().filter(|signal| !signal.is_level);
        let of_bus = |signal: &Signal| {
            let begins =
                |column: &Option<usize>| column.is_some_and(|clock| !signal.goes_on(clock));
            let starts = columns
                .iter()
                .enumerate()
                .filter(|(_, column)| begins(column));
            let starts: Vec<_> = starts.map(|(place, _)| place).collect();
            let ends = starts.iter().skip(1).copied().chain([columns.len()]);
            // The middle of columns a to b, without b, is in the middle of a column where their number is odd.
            let words = starts
                .iter()
                .zip(ends)
                .filter(|(start, end)| (end - **start) % 2 == 1);
            words
                .filter(|(start, end)| columns[(*start + end) / 2].is_none())
                .count()
        };
        buses.map(of_bus).sum()
    }

    /// The diagram as WaveJSON, a signal a line.
    pub fn wave_json(&self) -> String {
        let columns = self.columns();
        let number = |column: &Option<usize>| column.map_or('|', |_| '=');
        let numbers: Vec<_> = columns.iter().flatten().map(ToString::to_string).collect();
        let clock = columns
            .iter()
            .enumerate()
            .map(|(index, column)| match column {
                _ if index == 0 => 'p',
                Some(_) => '.',
                None => '|',
            });
        let mut lines = vec![
            line("clock", &clock.collect::<String>(), &[]),
            line(
                "number of the clock",
                &columns.iter().map(number).collect::<String>(),
                &numbers,
            ),
        ];
        for group in self.signals.chunk_by(|a, b| a.group == b.group) {
            let signals = group.iter().map(|signal| signal.wave(&columns));
            let signals: Vec<_> = signals.collect();
            let name = Value::from(group[0].group.as_str());
            lines.push(format!("[{name},\n    {}]", signals.join(",\n    ")));
        }
        format!(
            "{{ \"head\": {{ \"text\": {} }},\n  \"signal\": [\n  {}\n] }}\n",
            Value::from(self.title.as_str()),
            lines
                .join(",\n  {},\n  ")
                .replacen(",\n  {},\n  ", ",\n  ", 1)
        )
    }
}

/// The picture of a diagram in WaveJSON.
///
/// # Errors
/// The text is no WaveJSON.
pub fn picture(wave_json: &str, title: &str, description: &str) -> Result<String> {
    let figure = Figure::from_json(wave_json).context("WaveJSON")?;
    let assembled = figure.assemble();
    let mut svg = Vec::new();
    assembled.write_svg_with_options(&mut svg, &options())?;
    let svg = String::from_utf8(svg)?;
    let (head, shapes) = svg.split_once('>').context("an SVG has a head")?;
    let shapes = shapes.strip_suffix("</svg>").context("an SVG has an end")?;
    let side = |name: &str| -> Result<i32> {
        let begin = format!(" {name}=\"");
        let value = head
            .split_once(&begin)
            .and_then(|(_, rest)| rest.split_once('"'));
        Ok(value.context("an SVG has a size")?.0.parse()?)
    };
    let size = [side("width")?, side("height")?];
    let shapes = shapes
        .replace("font-family=\"Helvetica\"", "font-family=\"sans-serif\"")
        // The older name of the attribute needs a name space.
        .replace("xlink:href", "href")
        .replace("><", ">\n<");
    Ok(canvas::svg(
        size,
        title,
        description,
        &(themes() + "\n" + &shapes),
    ))
}

/// The colours of a light page.
fn options() -> RenderOptions {
    let [paper, ink, faint, second] =
        [LIGHT.paper, LIGHT.ink, LIGHT.faint, LIGHT.second].map(color);
    let mut options = RenderOptions {
        background: Some(paper),
        ..RenderOptions::default()
    };
    options.header.font_size = 16;
    options.header.color = ink;
    let signal = &mut options.signal;
    signal.marker_color = ink;
    signal.name_color = ink;
    signal.path_color = ink;
    signal.gap_color = ink;
    signal.gap_background_color = paper;
    signal.hint_line_color = faint;
    signal.undefined_color = faint;
    signal.backgrounds = [paper; 8];
    let group = &mut options.group_indicator;
    group.color = second;
    group.label_color = second;
    options.padding.figure_left = 16;
    options
}

fn color(RGBColor(red, green, blue): RGBColor) -> Color {
    Color { red, green, blue }
}

/// The rules that give a dark page its colours. They outdo the attributes of the shapes.
fn themes() -> String {
    let pairs = [
        (LIGHT.paper, DARK.paper),
        (LIGHT.ink, DARK.ink),
        (LIGHT.faint, DARK.faint),
        (LIGHT.second, DARK.second),
    ];
    let rules = pairs.iter().flat_map(|(light, dark)| {
        let light = color(*light).to_string();
        let dark = palette::css(*dark);
        ["fill", "stroke"].map(|name| format!("[{name}=\"{light}\"]{{{name}:{dark}}}"))
    });
    let rules: String = rules.collect();
    format!("<style>@media (prefers-color-scheme:dark){{{rules}}}</style>")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn signal(name: &str, is_level: bool, values: &[Option<u64>]) -> Signal {
        Signal {
            name: name.to_owned(),
            group: "stream".to_owned(),
            values: values.to_vec(),
            is_level,
            begins: vec![false; values.len()],
        }
    }

    fn diagram() -> Diagram {
        let valid: Vec<_> = [0, 1, 1, 1, 1, 1, 1, 1, 0].map(Some).into();
        let word: Vec<_> = valid
            .iter()
            .map(|bit| (*bit == Some(1)).then_some(42))
            .collect();
        Diagram {
            title: "two \"signals\"".to_owned(),
            clocks: valid.len(),
            signals: vec![signal("valid", true, &valid), signal("word", false, &word)],
        }
    }

    #[test]
    fn a_gap_stands_for_equal_clocks_and_covers_no_number() {
        let diagram = diagram();
        let columns = diagram.columns();
        assert_eq!(diagram.covered(&columns), 0);
        // With two clocks in front of the gap it would cover the 42 in the middle of five columns.
        let after_two = [Some(0), Some(1), Some(2), None, Some(6), Some(7), Some(8)];
        assert_eq!(diagram.covered(&after_two), 1);
        assert_eq!(columns, [Some(0), Some(1), Some(2), None, Some(7), Some(8)]);
    }

    #[test]
    fn the_json_has_the_levels_the_numbers_and_the_clocks_that_are_shown() {
        let text = diagram().wave_json();
        let read: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(read["head"]["text"], "two \"signals\"");
        let signals = read["signal"].as_array().unwrap();
        assert_eq!(signals[0]["wave"], "p..|..");
        assert_eq!(signals[1]["data"], json!(["0", "1", "2", "7", "8"]));
        let group = signals[3].as_array().unwrap();
        assert_eq!(group[0], "stream");
        assert_eq!(group[1]["wave"], "01.|.0");
        assert_eq!(
            (&group[2]["wave"], &group[2]["data"]),
            (&json!("x=.|.x"), &json!(["42"]))
        );
    }

    #[test]
    fn a_word_that_is_taken_begins_anew_though_the_next_is_equal() {
        let mut word = signal("word", false, &[Some(7), Some(7), Some(7)]);
        word.begins[2] = true;
        let columns = [Some(0), Some(1), Some(2)];
        assert!(
            word.wave(&columns).contains("\"=.=\""),
            "{}",
            word.wave(&columns)
        );
    }

    #[test]
    fn the_picture_has_title_description_and_the_colours_of_both_themes() {
        let svg = picture(&diagram().wave_json(), "a title", "in words").unwrap();
        assert!(svg.contains("<title id=\"title\">a title</title>"));
        assert!(svg.contains("viewBox=\"0 0 ") && svg.contains(">42<"));
        for set in [LIGHT, DARK] {
            let ink = palette::css(set.ink);
            assert!(svg.to_ascii_lowercase().contains(&ink), "{ink}");
        }
        assert!(picture("no JSON", "a title", "in words").is_err());
    }
}
