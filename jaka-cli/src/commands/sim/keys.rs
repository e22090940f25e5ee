//! Events of the simulated arm by single keys: the words of `--schedule` and `--stdin`, each under a key.

use std::io::{IsTerminal, stdin, stdout};
use std::sync::mpsc::Sender;
use std::thread;

use jaka_sim::{Happening, Level, State};
use ratatui::crossterm::event::{self, Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers};

use super::Typed;
use crate::failure::Failure;
use crate::terminal::output;
use crate::terminal::raw;
use crate::terminal::raw::Raw;

/// Range of keys, and their events, by their number from 0: the event, and after it has occurred, the opposite event.
struct KeyRow {
    keys: (char, char),
    does: fn(usize) -> Happening,
    undoes: Option<fn(usize) -> Happening>,
}

const ROWS: [KeyRow; 5] = [
    KeyRow { keys: ('c', 'c'), does: |_| Happening::Collide, undoes: None },
    KeyRow {
        keys: ('e', 'e'),
        does: |_| Happening::PressEmergencyStop,
        undoes: Some(|_| Happening::ReleaseEmergencyStop),
    },
    KeyRow { keys: ('p', 'p'), does: |_| Happening::CutPower, undoes: None },
    KeyRow {
        keys: ('0', '9'),
        does: |number| Happening::Input(number, Level::High),
        undoes: Some(|number| Happening::Input(number, Level::Low)),
    },
    KeyRow {
        keys: ('t', 't'),
        does: |_| Happening::ToolInput(0, Level::High),
        undoes: Some(|_| Happening::ToolInput(0, Level::Low)),
    },
];

/// Effect of a key.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Effect {
    Happens(Happening),
    Lists,
    Quits,
    Nothing,
}

/// Returns the effect of a key, for an arm in this state.
pub(super) fn effect(key: KeyEvent, state: &State) -> Effect {
    let KeyCode::Char(sign) = key.code else { return Effect::Nothing };
    if key.kind == KeyEventKind::Release {
        return Effect::Nothing;
    }
    if key.modifiers.contains(KeyModifiers::CONTROL) {
        // In this mode the terminal sends neither the signal nor the end of its input.
        return if matches!(sign, 'c' | 'd') { Effect::Quits } else { Effect::Nothing };
    }
    match sign {
        'q' => Effect::Quits,
        '?' => Effect::Lists,
        _ => happening(sign, state).map_or(Effect::Nothing, Effect::Happens),
    }
}

fn happening(sign: char, state: &State) -> Option<Happening> {
    let row = ROWS.iter().find(|row| (row.keys.0..=row.keys.1).contains(&sign))?;
    let number = sign.to_digit(10).map_or(0, |digit| digit as usize);
    let does = (row.does)(number);
    Some(match row.undoes {
        Some(undoes) if is_so(does, state) => undoes(number),
        _ => does,
    })
}

/// Whether this event has occurred, and the opposite has not.
fn is_so(happening: Happening, state: &State) -> bool {
    match happening {
        Happening::PressEmergencyStop => state.emergency_stop,
        Happening::Input(index, _) => state.digital_inputs.get(index) == Some(&true),
        Happening::ToolInput(index, _) => state.tool_digital_inputs.get(index) == Some(&true),
        _ => false,
    }
}

/// Returns all keys in a line.
pub(super) fn list() -> String {
    let rows = ROWS.iter().map(|row| {
        let (first, last) = row.keys;
        let keys = if first == last { first.to_string() } else { format!("{first} to {last}") };
        let undoes = row.undoes.map_or_else(String::new, |undoes| format!(" or {}", undoes(0)));
        format!("{keys} {}{undoes}", (row.does)(0))
    });
    format!("{}, ? this list, q quit", rows.collect::<Vec<_>>().join(", "))
}

pub(super) fn must_have_terminal() -> Result<(), Failure> {
    if stdin().is_terminal() && stdout().is_terminal() {
        return Ok(());
    }
    Err(Failure::Usage("`jaka sim --keys` needs a terminal; --stdin reads words".to_owned()))
}

/// Prints all keys.
pub(super) fn show() -> Result<(), Failure> {
    output::line(&format!("keys: {}", list()))
}

/// Prints the keys, and sends each pressed key from a reading thread, for as long as the result lives.
pub(super) fn begin(sender: Sender<Typed>) -> Result<Raw, Failure> {
    let raw = Raw::begin().map_err(|error| Failure::local("the terminal cannot be used", error))?;
    show()?;
    thread::spawn(move || {
        loop {
            match event::read() {
                Ok(Event::Key(key)) if sender.send(Typed::Key(key)).is_ok() => {}
                Ok(Event::Key(_)) => return,
                Ok(_) => {}
                Err(_) => return raw::end(),
            }
        }
    });
    Ok(raw)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use jaka_sim::Controller;

    use super::*;

    fn key(sign: char) -> KeyEvent {
        KeyEvent::new(KeyCode::Char(sign), KeyModifiers::NONE)
    }

    #[test]
    fn what_happens_to_the_arm_has_a_key() {
        let controller = Controller::start().expect("loopback has free ports");
        let before = controller.state();
        let mut after = before.clone();
        after.emergency_stop = true;
        after.digital_inputs.fill(true);
        after.tool_digital_inputs.fill(true);
        let effects = (' '..='~').flat_map(|sign| [effect(key(sign), &before), effect(key(sign), &after)]);
        let found: Vec<_> = effects.collect();
        for happening in Happening::one_of_each() {
            let has_values = matches!(
                happening,
                Happening::AnalogInput(..) | Happening::ToolAnalogInput(..) | Happening::Link { .. }
            );
            assert!(has_values || found.contains(&Effect::Happens(happening)), "{happening} has no key");
        }
    }

    #[test]
    fn keys_are_listed_and_end_it() {
        expect!["c collide, e press-emergency-stop or release-emergency-stop, p cut-power, 0 to 9 input 0 high or input 0 low, t tool-input 0 high or tool-input 0 low, ? this list, q quit"].assert_eq(&list());
        let controller = Controller::start().expect("loopback has free ports");
        let state = controller.state();
        let control = |sign| KeyEvent::new(KeyCode::Char(sign), KeyModifiers::CONTROL);
        for (pressed, expected) in [
            (key('?'), Effect::Lists),
            (key('q'), Effect::Quits),
            (control('c'), Effect::Quits),
            (control('d'), Effect::Quits),
            (control('e'), Effect::Nothing),
            (key('x'), Effect::Nothing),
            (KeyEvent::new(KeyCode::Esc, KeyModifiers::NONE), Effect::Nothing),
            (KeyEvent { kind: KeyEventKind::Release, ..key('c') }, Effect::Nothing),
            (KeyEvent::new(KeyCode::Char('7'), KeyModifiers::NONE), Effect::Happens(Happening::Input(7, Level::High))),
        ] {
            assert_eq!(effect(pressed, &state), expected, "{pressed:?}");
        }
    }
}
