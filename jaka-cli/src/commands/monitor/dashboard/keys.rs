//! Keys of the dashboard. No key sends anything to the robot.

use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};

use super::View;
use super::view::Page;

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
    /// Carries out a key. True if it ends the dashboard.
    pub(crate) fn ends_after(&mut self, key: KeyEvent) -> bool {
        if key.kind == KeyEventKind::Release {
            return false;
        }
        match key.code {
            KeyCode::Char('c') if key.modifiers.contains(KeyModifiers::CONTROL) => return true,
            KeyCode::Char('q' | 'Q') => return true,
            KeyCode::Esc if !self.help => return true,
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
        false
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

    fn press(view: &mut View, code: KeyCode) -> bool {
        view.ends_after(KeyEvent::new(code, KeyModifiers::NONE))
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
        assert!(press(&mut view, KeyCode::Char('q')));
        assert!(view.ends_after(KeyEvent::new(KeyCode::Char('c'), KeyModifiers::CONTROL)));
        assert!(!press(&mut view, KeyCode::Char('c')));
        press(&mut view, KeyCode::Char('?'));
        assert!(!press(&mut view, KeyCode::Esc), "closes the help");
        assert!(press(&mut view, KeyCode::Esc));
    }
}
