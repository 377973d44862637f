//! How bars of a chart are drawn that have no room as they are, and what the maker is told of it.

use crate::lines::PagePart;
use crate::{About, Note, Reason, Told};

/// How bars that are torn are drawn instead.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct BarStyle {
    pub(super) bars: Bars,
    pub(super) left_out: LeftOut,
    /// How many bars are too low for an outline.
    pub(super) low: usize,
    /// Whether a bar beside an axis is drawn as standing at it.
    pub(super) is_at_axis: bool,
    /// How much of the outlines of bars is not drawn all the same, percent, rounded up.
    pub(super) torn: u32,
}

/// What is left out beside bars, so that they have room.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LeftOut {
    Nothing,
    Gridlines,
    /// The side beyond the bars of the frame around them.
    FrameSide,
}

impl LeftOut {
    /// Of a chart whose `has_grid` says whether it has gridlines to leave out.
    pub(super) fn of(has_gridlines: bool, has_grid: bool) -> Self {
        match (has_gridlines, has_grid) {
            (true, _) => Self::Nothing,
            (false, true) => Self::Gridlines,
            (false, false) => Self::FrameSide,
        }
    }
}

/// How the bars of a row stand beside one another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Bars {
    Apart,
    /// The same, each a little narrower, and all moved aside a little.
    Narrower,
    /// A line between every two.
    Touching,
    /// None.
    Outline,
}

/// What the maker is told of bars that are drawn otherwise, in the figure and in the overview.
pub(super) fn told(in_figure: Option<BarStyle>, in_overview: Option<BarStyle>) -> Vec<Note> {
    let in_overview = in_overview.map(|style| in_figure.map_or(style, |figure| style.beside(figure)));
    let of_figure = in_figure.iter().flat_map(|instead| instead.told(PagePart::Figure));
    of_figure.chain(in_overview.iter().flat_map(|instead| instead.told(PagePart::Overview))).collect()
}

impl BarStyle {
    pub(super) const AS_IT_IS: Self =
        Self { bars: Bars::Apart, left_out: LeftOut::Nothing, low: 0, is_at_axis: false, torn: 0 };

    /// What of an overview is told beside its figure: what is so in both is no news.
    fn beside(self, figure: Self) -> Self {
        let bars = if self.bars == figure.bars { Bars::Apart } else { self.bars };
        let low = if self.low == figure.low { 0 } else { self.low };
        let left_out = if self.left_out == figure.left_out { LeftOut::Nothing } else { self.left_out };
        Self { bars, low, left_out, is_at_axis: self.is_at_axis && !figure.is_at_axis, ..self }
    }

    fn told(self, part: PagePart) -> Vec<Note> {
        let (about, place) = match part {
            PagePart::Figure => (About::Lines, ""),
            PagePart::Overview => (About::Overview, "in the overview "),
        };
        let helped = |told: String| match part {
            PagePart::Figure => Told::from(told).or_larger(),
            PagePart::Overview => told.into(),
        };
        let bars = match self.bars {
            // as other lines are moved a little
            Bars::Apart | Bars::Narrower => None,
            Bars::Touching => Some("touch one another, without gaps"),
            Bars::Outline => Some("are drawn as one common outline, without lines between them"),
        };
        let joined = bars.map(|how| {
            let why = "as there is no room for more; their heights are right";
            let told = format!("{place}the bars of the chart {how}, {why}");
            Note::TakenAs(about, Reason::BarsJoined, helped(told))
        });
        let low = (self.low > 0).then(|| {
            let bars = if self.low == 1 { "1 bar" } else { &format!("{} bars", self.low) };
            let what =
                format!("{place}{bars} of the chart, too low for an outline that fingers can tell from the base");
            Note::NotOnPage(about, Reason::BarTooLow, what.into())
        });
        let at_axis = self.is_at_axis.then(|| {
            let told = format!("{place}a bar beside an axis is drawn as standing at it, as there is no room between");
            Note::TakenAs(about, Reason::BarAtAxis, told.into())
        });
        let left_out = match self.left_out {
            LeftOut::Nothing => None,
            LeftOut::Gridlines => Some("the gridlines of the chart"),
            LeftOut::FrameSide => Some("the side of the frame around the chart that lies beyond its bars"),
        };
        let grid = left_out.map(|what| {
            let told = format!("{what}, {place}as a whole, so that its bars have room");
            Note::NotOnPage(about, Reason::ChartGrid, told.into())
        });
        let torn = (self.torn > 0).then(|| {
            let torn = self.torn;
            let told =
                format!("{place}{torn} percent of the outlines of bars of the chart, as there is no room for them");
            Note::NotOnPage(about, Reason::BarTorn, helped(told))
        });
        joined.into_iter().chain(at_axis).chain(grid).chain(low).chain(torn).collect()
    }
}

#[cfg(test)]
mod tests;
