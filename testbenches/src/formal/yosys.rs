//! Runs Yosys's `sat` for a list of questions and reads the answers: a proof, a counter-example, or neither.
//! Only Yosys's last word on a question counts; no output, an error and a time-out prove nothing.

use std::time::Duration;

use crate::device::{DeviceError, scratch_folder, write_file};
use crate::tools::{script_for, tail, yosys};

/// The time limit of a question in seconds. The slowest question that is answered takes a twentieth of it on
/// a small machine.
pub(super) const SECONDS_EACH: u64 = 120;

/// A mark in the log before the output of each question.
const MARK: &str = "photoncube-question";

/// A question for `sat`.
#[derive(Clone, Debug)]
pub(super) struct Question {
    /// The commands that precede it.
    pub before: &'static str,
    /// The options of `sat`, and the module.
    pub options: String,
}

impl Question {
    /// The line, or lines, of a script.
    fn command(&self) -> String {
        let Self { before, options } = self;
        format!("{before}sat -timeout {SECONDS_EACH} {options}\n")
    }
}

/// The answer of `sat`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Answer {
    /// The condition always holds, or holds for the number of clocks in question.
    Holds,
    /// There is a state in which the condition does not hold.
    Refuted,
    /// The state that was searched exists.
    Found,
    /// The state that was searched does not exist.
    NotFound,
    /// No answer; the text is the tool's last output.
    None(String),
}

/// Yosys's messages that end a question, with their meaning.
const WORDS: [(&str, Answer); 7] = [
    ("Induction step proven: SUCCESS!", Answer::Holds),
    (
        "SAT proof finished - no model found: SUCCESS!",
        Answer::Holds,
    ),
    ("proved base case for", Answer::Holds),
    (
        "SAT temporal induction proof finished - model found for base case: FAIL!",
        Answer::Refuted,
    ),
    ("SAT proof finished - model found: FAIL!", Answer::Refuted),
    ("SAT solving finished - model found:", Answer::Found),
    ("SAT solving finished - no model found.", Answer::NotFound),
];

/// Files for Yosys, by name.
pub(super) type Files<'a> = [(&'a str, &'a str)];

/// The name of the design's file.
pub(super) const DESIGN: &str = "design.v";

/// Runs the commands, then each question on their result.
///
/// # Errors
/// Yosys is missing or does not start, or a file cannot be written.
pub(super) fn ask(
    files: &Files<'_>,
    commands: &str,
    questions: &[Question],
) -> Result<Vec<Answer>, DeviceError> {
    let mut script = commands.to_owned();
    for (index, question) in questions.iter().enumerate() {
        script += &format!("\nlog {MARK} {index}\n{}", question.command());
    }
    answers_of(files, &script, questions.len())
}

/// Asks the question of each of these designs. The commands read the design as the file [`DESIGN`], and run anew for each. One run of
/// Yosys answers all, because Yosys takes longer to start than to answer most questions.
///
/// # Errors
/// Yosys is missing or does not start, or a file cannot be written.
pub(super) fn ask_of_each(
    designs: &[String],
    files: &Files<'_>,
    commands: &str,
    question: &Question,
) -> Result<Vec<Answer>, DeviceError> {
    let names: Vec<_> = (0..designs.len())
        .map(|index| format!("{index}_{DESIGN}"))
        .collect();
    let texts = names.iter().zip(designs);
    let texts = texts.map(|(name, text)| (name.as_str(), text.as_str()));
    let files: Vec<_> = texts.chain(files.iter().copied()).collect();
    let mut script = String::new();
    for (index, name) in names.iter().enumerate() {
        let commands = commands.replace(DESIGN, name);
        let question = question.command();
        script += &format!("log {MARK} {index}\ndesign -reset\n{commands}\n{question}");
    }
    answers_of(&files, &script, designs.len())
}

/// Runs a script with a mark before the output of each question.
fn answers_of(
    files: &Files<'_>,
    script: &str,
    questions: usize,
) -> Result<Vec<Answer>, DeviceError> {
    let limit = Duration::from_secs(SECONDS_EACH * (questions as u64 + 1));
    let log = run(files, script, limit)?;
    Ok(answers(&log, questions))
}

/// Runs a script and returns Yosys's output, to its end or to the time limit.
///
/// # Errors
/// Yosys is missing or does not start, or a file cannot be written.
pub(super) fn run(files: &Files<'_>, script: &str, limit: Duration) -> Result<String, DeviceError> {
    let folder = scratch_folder()?;
    for (name, text) in files {
        write_file(&folder.path().join(name), text)?;
    }
    let yosys = yosys()?;
    let script = script_for(&yosys, script)?;
    write_file(&folder.path().join(fpga_flow::SCRIPT), &script)?;
    Ok(yosys.log_within(folder.path(), limit)?)
}

/// The answer to each question in a log.
fn answers(log: &str, questions: usize) -> Vec<Answer> {
    let part = |index: usize| {
        let begin = log.find(&format!("\n{MARK} {index}\n"))?;
        let part = &log[begin + 1..];
        let end = part.find(&format!("\n{MARK} {}\n", index + 1));
        Some(&part[..end.unwrap_or(part.len())])
    };
    let last = || Answer::None(tail(log.as_bytes()));
    (0..questions)
        .map(|index| part(index).map_or_else(last, answer))
        .collect()
}

/// The answer in the output of one question: the only message of [`WORDS`] in it.
fn answer(said: &str) -> Answer {
    let found = WORDS.iter().filter(|(word, _)| said.contains(word));
    match &found.collect::<Vec<_>>()[..] {
        [(_, answer)] if !said.contains("ERROR") && !said.contains("TIMEOUT") => answer.clone(),
        _ => Answer::None(tail(said.as_bytes())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_one_plain_word_is_an_answer() {
        assert_eq!(
            answer("..\nInduction step proven: SUCCESS!\n"),
            Answer::Holds
        );
        let none = |said| matches!(answer(said), Answer::None(_));
        assert!(none(""));
        assert!(none("Interrupted SAT solver: TIMEOUT!"));
        assert!(none(
            "SAT proof finished - no model found: SUCCESS!\nERROR: no such module"
        ));
        assert!(none(
            "Induction step proven: SUCCESS!\nSAT proof finished - model found: FAIL!"
        ));
        assert!(none(
            "Reached maximum number of time steps -> proof failed."
        ));
    }

    #[test]
    fn each_question_has_its_own_part_of_the_log() {
        let log = format!(
            "read\n{MARK} 0\nSAT proof finished - model found: FAIL!\n{MARK} 1\n\
             SAT solving finished - model found:\n"
        );
        assert_eq!(answers(&log, 2), [Answer::Refuted, Answer::Found]);
        assert!(
            matches!(&answers("ERROR: gone", 1)[..], [Answer::None(said)] if said.contains("gone"))
        );
    }

    #[test]
    #[ignore = "needs Yosys: scripts/setup.sh installs it"]
    fn each_design_has_its_own_answer() {
        let of = |sum: &str| {
            format!(
                "module m(input [3:0] a, output holds);\nassign holds = ({sum}) == a + a;\nendmodule\n"
            )
        };
        let designs = ["a << 1", "a | 4'd1", "{a[2:0], 1'b0}", "a +"].map(of);
        let question = Question {
            before: "",
            options: "-prove holds 1 m".to_owned(),
        };
        let commands = format!("read_verilog {DESIGN}\nprep -top m");
        let answers = ask_of_each(&designs, &[], &commands, &question).unwrap();
        let [
            Answer::Holds,
            Answer::Refuted,
            Answer::Holds,
            Answer::None(said),
        ] = &answers[..]
        else {
            panic!("{answers:?}");
        };
        assert!(
            said.contains("3_design.v") && said.contains("ERROR"),
            "{said}"
        );
    }
}
