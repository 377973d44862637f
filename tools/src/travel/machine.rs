//! A BrailleRAP that reads G-code as its firmware does, but forgives nothing.

use tactograph::internals::output::dots::gcode::Params;
use tactograph::internals::output::dots::path_order::DotPosition;

/// What the firmware holds the axes to, hundredths of a millimetre: it goes no farther (MarlinBraille2).
const BED: DotPosition = [30_000, 42_000];
/// How long the magnet holds a dot, s: 15 ms on, 10 ms off (MarlinBraille2).
const PRESS: f64 = 0.025;

/// A sheet that has come out of the machine.
#[derive(Debug, Default)]
pub struct Sheet {
    /// Dots in the order in which they were pressed, hundredths of a millimetre.
    pub dots: Vec<DotPosition>,
    /// Way of the needle over the paper, from its zero until the paper is out, hundredths of a millimetre.
    pub travel: f64,
    /// Time for it, s.
    pub seconds: f64,
}

#[derive(Debug, Default)]
struct Machine {
    homed: [bool; 2],
    at: DotPosition,
    acceleration: f64,
    feed: f64,
    down: bool,
    off: bool,
    /// The paper has been fed beyond what the needle reaches.
    fed_out: bool,
    sheet: Sheet,
}

/// Runs `gcode` on a machine whose needle reaches `limits` and whose paper is `length` long, in hundredths of a
/// millimetre. The machine starts as Marlin does: millimetres, absolute places, nothing homed.
pub fn run(gcode: &str, limits: DotPosition, length: i32) -> Result<Sheet, String> {
    let mut machine = Machine::default();
    let Some(text) = gcode.strip_suffix("\r\n") else { return Err("the last line has no end".into()) };
    for (number, line) in text.split("\r\n").enumerate() {
        machine.line(line, limits).map_err(|why| format!("line {}: {line:?}: {why}", number + 1))?;
    }
    match machine {
        Machine { off: false, .. } => Err("the motors stay on".into()),
        Machine { at, .. } if at[0] != 0 || at[1] < length => Err(format!("the sheet stays in, at {at:?}")),
        Machine { sheet, .. } => Ok(sheet),
    }
}

impl Machine {
    fn line(&mut self, line: &str, limits: DotPosition) -> Result<(), String> {
        if line.contains(['\r', '\n']) {
            return Err("half an end of a line".into());
        }
        let command = line.split(';').next().unwrap_or_default().trim_end();
        let words: Vec<&str> = command.split(' ').collect();
        if self.off {
            return Err("the motors are off".into());
        }
        match words[..] {
            ["G21" | "G90"] => Ok(()),
            ["G20" | "G91"] => Err("inches and ways from place to place are not for this machine".into()),
            ["G28", "X"] => self.home(0),
            ["G28", "Y"] => self.home(1),
            ["M204", travel] => {
                self.acceleration = positive(travel, 'T')?;
                Ok(())
            }
            ["G1", feed] if feed.starts_with('F') => {
                self.feed = positive(feed, 'F')? / 60.0;
                Ok(())
            }
            ["G1", x, y] => self.go([place(x, 'X')?, place(y, 'Y')?], limits),
            ["M3", "S1"] => self.press(),
            ["M3", "S0"] => {
                self.down = false;
                Ok(())
            }
            ["M84"] if self.down => Err("the needle is down".into()),
            ["M84"] => {
                self.off = true;
                Ok(())
            }
            // Marlin does not answer to a line without a command, so that a sender waits for ever.
            [""] => Err("no command".into()),
            _ => Err("unknown command".into()),
        }
    }

    fn home(&mut self, axis: usize) -> Result<(), String> {
        if self.down {
            return Err("the needle is down".into());
        }
        self.homed[axis] = true;
        self.at[axis] = 0;
        Ok(())
    }

    fn go(&mut self, to: DotPosition, limits: DotPosition) -> Result<(), String> {
        let within = |most: DotPosition| (0..2).all(|axis| (0..=most[axis]).contains(&to[axis]));
        if self.homed != [true, true] {
            return Err("the machine does not know where it is".into());
        } else if self.down {
            return Err("the needle is down".into());
        } else if self.acceleration <= 0.0 || self.feed <= 0.0 {
            return Err("no acceleration or feed".into());
        } else if self.fed_out {
            return Err("the paper is already out".into());
        } else if !within(limits) {
            if to[0] != 0 || to[1] <= limits[1] {
                return Err(format!("off the limits {limits:?}"));
            }
            self.fed_out = true;
        }
        let to = [to[0].min(BED[0]), to[1].min(BED[1])];
        let way = f64::from(to[0] - self.at[0]).hypot(f64::from(to[1] - self.at[1]));
        self.sheet.travel += way;
        self.sheet.seconds += self.seconds(way / 100.0);
        self.at = to;
        Ok(())
    }

    /// From rest to rest over so many millimetres.
    fn seconds(&self, way: f64) -> f64 {
        let speeding_up = self.feed * self.feed / self.acceleration;
        if way < speeding_up {
            2.0 * (way / self.acceleration).sqrt()
        } else {
            self.feed / self.acceleration + way / self.feed
        }
    }

    fn press(&mut self) -> Result<(), String> {
        if self.down {
            return Err("the needle is down already".into());
        } else if self.homed != [true, true] {
            return Err("the machine does not know where it is".into());
        } else if self.fed_out {
            return Err("there is no paper".into());
        }
        self.down = true;
        self.sheet.dots.push(self.at);
        self.sheet.seconds += PRESS;
        Ok(())
    }
}

fn positive(word: &str, letter: char) -> Result<f64, String> {
    let value: u32 = word.strip_prefix(letter).and_then(|value| value.parse().ok()).ok_or("no whole number")?;
    if value == 0 { Err("0 stops the machine".into()) } else { Ok(f64::from(value)) }
}

/// Digits, a point, two digits.
fn place(word: &str, letter: char) -> Result<i32, String> {
    let number = word.strip_prefix(letter).and_then(|number| number.split_once('.'));
    let (whole, part) = number.ok_or_else(|| format!("no {letter} with a point"))?;
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    if !digits(whole) || !digits(part) || part.len() != 2 {
        return Err(format!("{word} is not in hundredths"));
    }
    [whole, part].concat().parse().map_err(|_| format!("{word} is too large"))
}

/// BrailleRAP XL with A4: 210 mm across and 250 mm down (DesktopBrailleRAP).
pub fn xl_a4() -> Params {
    Params { limits: [210.0, 250.0], ..Params::a4() }
}

/// BrailleRAP XL with A3: 297 mm across and 373 mm down, which is 47 mm less than the sheet as with A4
/// (DesktopBrailleRAP).
pub fn xl_a3() -> Params {
    Params { limits: [297.0, 373.0], paper_length: 420.0, ..Params::a4() }
}
