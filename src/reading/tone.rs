//! What prints: the one decision which paints are black and which are white, for those who read pages and those who
//! check them.

/// The channels of a paint (0..=255) up to this are black ink.
const BLACK: u8 = 16;
/// From this on nothing is printed.
const WHITE: u8 = 248;

/// Whether a paint is black ink.
pub fn is_black([red, green, blue]: [u8; 3]) -> bool {
    red.max(green).max(blue) <= BLACK
}

/// Whether a paint prints nothing.
pub fn is_white([red, green, blue]: [u8; 3]) -> bool {
    red.min(green).min(blue) >= WHITE
}

/// How light a paint looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Tone {
    /// Its grey value, 0 black.
    pub(super) grey: u8,
    pub(super) is_black: bool,
    pub(super) is_white: bool,
}

impl Tone {
    pub(super) const BLACK: Self = Self { grey: 0, is_black: true, is_white: false };

    /// Of a paint as it looks on white paper.
    pub(super) fn of(channels: [u8; 3]) -> Self {
        let [red, green, blue] = channels.map(u32::from);
        let grey = ((299 * red + 587 * green + 114 * blue) / 1000) as u8;
        Self { grey, is_black: is_black(channels), is_white: is_white(channels) }
    }

    /// Whether it prints, in grey or in colour.
    pub(super) fn is_shaded(self) -> bool {
        !self.is_black && !self.is_white
    }
}
