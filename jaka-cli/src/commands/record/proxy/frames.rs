//! Messages in a byte stream, for the recording.

use jaka_robot::proto::framing::{FrameError, Framer};

/// Splits a byte stream into messages and other bytes, and drops only white space between messages.
#[derive(Debug, Default)]
pub(super) struct MessageFrames {
    framer: Framer,
}

/// Piece of a byte stream.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Piece<'b> {
    /// Message.
    Message(&'b [u8]),
    /// Bytes that are not a message.
    Stray(&'b [u8]),
}

impl MessageFrames {
    /// Takes received bytes, and reports each piece that they complete.
    pub(super) fn take(&mut self, bytes: &[u8], mut tell: impl FnMut(Piece<'_>)) {
        self.framer.push(bytes);
        loop {
            match self.framer.next_frame() {
                Ok(Some(frame)) => tell(Piece::Message(frame)),
                Ok(None) => return,
                Err(error) => self.skip(&error, &mut tell),
            }
        }
    }

    /// Reports the bytes of an incomplete message at the end of the stream.
    pub(super) fn finish(self, mut tell: impl FnMut(Piece<'_>)) {
        if !self.framer.is_idle() {
            tell(Piece::Stray(self.framer.partial()));
        }
    }

    /// Continues after bytes that are not a message: at the next brace, or with the next received bytes. It does not
    /// move later bytes, so that the time for any stream is linear in its length.
    fn skip(&mut self, error: &FrameError, tell: &mut impl FnMut(Piece<'_>)) {
        let waiting = self.framer.partial();
        let next = match error {
            FrameError::Garbage { .. } => waiting.iter().position(|&byte| byte == b'{'),
            // The braces within it do not start messages.
            _ => None,
        };
        tell(Piece::Stray(&waiting[..next.unwrap_or(waiting.len())]));
        if next.is_some() {
            self.framer.resync();
        } else {
            self.framer = Framer::default();
        }
    }
}

#[cfg(test)]
mod tests {
    use jaka_robot::proto::framing::DEFAULT_MAX_FRAME;

    use super::*;

    /// Returns the pieces of a stream cut at these positions, with messages between angle brackets.
    fn pieces(stream: &[u8], cuts: &[usize]) -> String {
        let mut out = String::new();
        let mut note = |piece: Piece<'_>| match piece {
            Piece::Message(bytes) => out.extend(["<", &String::from_utf8_lossy(bytes), ">"]),
            Piece::Stray(bytes) => out += &String::from_utf8_lossy(bytes),
        };
        let mut frames = MessageFrames::default();
        let mut start = 0;
        for &cut in cuts {
            frames.take(&stream[start..cut], &mut note);
            start = cut;
        }
        frames.take(&stream[start..], &mut note);
        frames.finish(&mut note);
        out
    }

    #[test]
    fn messages_are_found_however_the_stream_is_cut() {
        let stream = br#"{"a":"}"} {"b":{}}(1,(2))"#;
        for cut in 0..=stream.len() {
            assert_eq!(pieces(stream, &[cut]), r#"<{"a":"}"}><{"b":{}}><(1,(2))>"#, "{cut}");
        }
    }

    /// Tests a stream in one piece: with a copy of all later bytes for each stray byte, it would take days.
    #[test]
    fn garbage_between_braces_takes_linear_time() {
        let stream = b"x{}".repeat(2 << 20);
        let (mut messages, mut stray) = (0, 0);
        let mut frames = MessageFrames::default();
        frames.take(&stream, |piece| match piece {
            Piece::Message(_) => messages += 1,
            Piece::Stray(bytes) => stray += bytes.len(),
        });
        assert_eq!((messages, stray), (2 << 20, 2 << 20));
        assert!(frames.framer.visited() <= stream.len() as u64);
    }

    #[test]
    fn bytes_that_are_not_a_message_are_kept() {
        assert_eq!(pieces(b"x y{}z", &[]), "x y<{}>z");
        assert_eq!(pieces(b"xx{}", &[1]), "xx<{}>");
        assert_eq!(pieces(b"{}{\"cut", &[]), "<{}>{\"cut");
        assert_eq!(pieces(b"{} \n", &[]), "<{}>");
        let long = vec![b'{'; DEFAULT_MAX_FRAME + 1];
        assert_eq!(pieces(&[&long, &b"{}"[..]].concat(), &[long.len()]).len(), long.len() + 4);
    }
}
