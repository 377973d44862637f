//! The formats of dots: against what the drivers of CUPS made of the same dots (`recorded/`), against small models of
//! our own on random pages, and read back.

mod index;
mod pef;
pub(crate) use tactograph_tools::dot_reading as reading;
mod recorded;
mod text;

use tactograph::internals::output::dots::DotMatrix;

/// Numbers that are the same on every run: a linear congruential generator, with the constants of Knuth's MMIX.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % end
    }

    /// A page of any size, sides of whole cells and others, full and nearly empty.
    fn page(&mut self) -> DotMatrix {
        let (columns, rows, rarity) = (self.below(40), self.below(40), 1 + self.below(30));
        let mut page = reading::matrix(columns, rows);
        for (x, y) in (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))) {
            if self.below(rarity) == 0 {
                page.raise(x, y, 1 + self.below(3) as u8);
            }
        }
        page
    }

    fn pages(&mut self) -> Vec<DotMatrix> {
        (0..self.below(4)).map(|_| self.page()).collect()
    }
}

/// What is raised on a page, whatever its size and heights.
fn dots(page: &DotMatrix) -> Vec<(usize, usize)> {
    let all = (0..page.rows()).flat_map(|y| (0..page.columns()).map(move |x| (x, y)));
    all.filter(|&(x, y)| page.is_raised(x, y)).collect()
}
