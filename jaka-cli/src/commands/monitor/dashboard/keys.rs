//! Keys of the dashboard. No key sends anything to the robot.

use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};

use super::View;
use super::view::Page;

/// Effect of a key on the dashboard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum AfterKey {
    /// The dashboard continues.
    Continue,
    /// The dashboard ends.
    Quit,
}

/// Keys, for the help.
pub(super) const KEYS: [(&str, &str); 6] = [
    ("q, Esc, Ctrl-C", "quit"),
    ("p", "pause or continue"),
    ("Tab, → and Shift-Tab, ←", "next page, previous page"),
    ("1 to 4", "go to a page"),
    ("↑ ↓ PgUp PgDn Home", "scroll"),
    ("?", "this help"),
];

impl View {
    /// Carries out a key.
    pub(crate) fn key(&mut self, key: KeyEvent) -> AfterKey {
        if key.kind == KeyEventKind::Release {
            return AfterKey::Continue;
        }
        match key.code {
            KeyCode::Char('c') if key.modifiers.contains(KeyModifiers::CONTROL) => return AfterKey::Quit,
            KeyCode::Char('q' | 'Q') => return AfterKey::Quit,
            KeyCode::Esc if !self.help => return AfterKey::Quit,
            KeyCode::Esc => self.help = false,
            KeyCode::Char('?' | 'h') => self.help = !self.help,
            KeyCode::Char('p' | ' ') => self.paused = !self.paused,
            KeyCode::Tab | KeyCode::Right => self.turn_to(self.page.step(1)),
            KeyCode::BackTab | KeyCode::Left => self.turn_to(self.page.step(Page::ALL.len() - 1)),
            KeyCode::Char(digit @ '1'..='4') => {
                self.turn_to(Page::Overview.step(digit.to_digit(10).map_or(0, |digit| digit as usize - 1)));
            }
            KeyCode::Up => self.scroll = self.scroll.saturating_sub(1),
            KeyCode::Down => self.scroll = self.scroll.saturating_add(1),
            KeyCode::PageUp => self.scroll = self.scroll.saturating_sub(10),
            KeyCode::PageDown => self.scroll = self.scroll.saturating_add(10),
            KeyCode::Home => self.scroll = 0,
            _ => {}
        }
        AfterKey::Continue
    }

    fn turn_to(&mut self, page: Page) {
        self.page = page;
        self.scroll = 0;
        self.help = false;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(view: &mut View, code: KeyCode) -> AfterKey {
        view.key(KeyEvent::new(code, KeyModifiers::NONE))
    }

    #[test]
    fn pages_go_round() {
        let mut view = View::default();
        press(&mut view, KeyCode::BackTab);
        assert_eq!(view.page, Page::Alarms);
        press(&mut view, KeyCode::Tab);
        assert_eq!(view.page, Page::Overview);
        press(&mut view, KeyCode::Down);
        press(&mut view, KeyCode::Char('2'));
        assert_eq!((view.page, view.scroll), (Page::Io, 0));
    }

    #[test]
    fn the_usual_keys_quit() {
        let mut view = View::default();
        assert_eq!(press(&mut view, KeyCode::Char('q')), AfterKey::Quit);
        assert_eq!(view.key(KeyEvent::new(KeyCode::Char('c'), KeyModifiers::CONTROL)), AfterKey::Quit);
        assert_eq!(press(&mut view, KeyCode::Char('c')), AfterKey::Continue);
        press(&mut view, KeyCode::Char('?'));
        assert_eq!(press(&mut view, KeyCode::Esc), AfterKey::Continue, "closes the help");
        assert_eq!(press(&mut view, KeyCode::Esc), AfterKey::Quit);
    }
}
