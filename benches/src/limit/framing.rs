//! Cutting a byte stream: what it costs to append alone, and the usual ways of finding the end of a message.

/// Appends pieces to a buffer that is emptied where a message ends, as if somebody else knew the place.
pub fn append(stream: &[u8], piece: usize, message: usize, buffer: &mut Vec<u8>) -> usize {
    let mut found = 0;
    for piece in stream.chunks(piece) {
        buffer.extend_from_slice(piece);
        if buffer.len() >= message {
            std::hint::black_box(&buffer[..]);
            buffer.clear();
            found += 1;
        }
    }
    found
}

/// State of a scanner that looks at each byte.
#[derive(Debug, Default)]
pub struct Bytewise {
    buffer: Vec<u8>,
    at: usize,
    depth: usize,
    in_string: bool,
    escaped: bool,
}

impl Bytewise {
    /// Appends pieces and looks at each byte once; how many messages ended.
    pub fn run(&mut self, stream: &[u8], piece: usize) -> usize {
        let mut found = 0;
        for piece in stream.chunks(piece) {
            self.buffer.extend_from_slice(piece);
            while self.message_ends() {
                std::hint::black_box(&self.buffer[..self.at]);
                self.buffer.drain(..self.at);
                self.at = 0;
                found += 1;
            }
        }
        found
    }

    fn message_ends(&mut self) -> bool {
        while let Some(&byte) = self.buffer.get(self.at) {
            self.at += 1;
            if self.in_string {
                let ends = byte == b'"' && !self.escaped;
                self.escaped = byte == b'\\' && !self.escaped;
                self.in_string = !ends;
                continue;
            }
            match byte {
                b'"' => self.in_string = true,
                b'{' => self.depth += 1,
                b'}' => {
                    self.depth -= 1;
                    if self.depth == 0 {
                        return true;
                    }
                }
                _ => {}
            }
        }
        false
    }
}
