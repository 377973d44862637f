//! A scene and the truth about it, in pixels: x right, y down, pixel centres at +0.5.

pub(crate) use tactograph_tools::P;
/// Red, green and blue in code values.
pub(crate) type Colour = [f64; 3];

/// What a scene is about; measures are summed by this.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Family {
    Straight,
    SmallDisc,
    LargeDisc,
    Ellipse,
    Sine,
    Polygon,
    Junction,
    Bar,
    Parallel,
    Stair,
    Ramp,
    IsoColour,
    Flat,
    Shading,
    Texture,
}

impl Family {
    #[cfg(test)]
    pub(crate) const ALL: [Self; 15] = [
        Self::Straight,
        Self::SmallDisc,
        Self::LargeDisc,
        Self::Ellipse,
        Self::Sine,
        Self::Polygon,
        Self::Junction,
        Self::Bar,
        Self::Parallel,
        Self::Stair,
        Self::Ramp,
        Self::IsoColour,
        Self::Flat,
        Self::Shading,
        Self::Texture,
    ];
    /// Smooth lone contours: place, pieces and closure are judged on these.
    pub(crate) const SMOOTH: [Self; 5] = [Self::Straight, Self::SmallDisc, Self::LargeDisc, Self::Ellipse, Self::Sine];

    /// A short word for file names and tables.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Straight => "straight",
            Self::SmallDisc => "disc-r5-30",
            Self::LargeDisc => "disc-r45-200",
            Self::Ellipse => "ellipse",
            Self::Sine => "sine",
            Self::Polygon => "polygon",
            Self::Junction => "junction",
            Self::Bar => "bar",
            Self::Parallel => "parallel",
            Self::Stair => "stair",
            Self::Ramp => "ramp",
            Self::IsoColour => "iso-colour",
            Self::Flat => "flat",
            Self::Shading => "shading",
            Self::Texture => "texture",
        }
    }
}

/// How an area is coloured.
pub(crate) enum Fill {
    Flat(Colour),
    Varying(Box<dyn Fn(P) -> Colour>),
}

impl Fill {
    /// A flat grey.
    pub(crate) fn grey(value: f64) -> Self {
        Self::Flat([value; 3])
    }
}

/// An area painted over what is below it.
pub(crate) struct Layer {
    pub(crate) outline: Vec<P>,
    pub(crate) fill: Fill,
}

/// A true contour, as points at most a quarter of a pixel apart.
#[derive(Debug, Clone, Default)]
pub(crate) struct Curve {
    pub(crate) points: Vec<P>,
    /// Whether the last point joins the first.
    pub(crate) closed: bool,
    /// Height of the step at each point, code values.
    pub(crate) contrast: Vec<f64>,
}

/// A place where contours meet, and the unit vectors along which they leave it.
pub(crate) struct Junction {
    pub(crate) at: P,
    pub(crate) branches: Vec<P>,
}

/// A picture's recipe and what a perfect detector would find in it.
pub(crate) struct Scene {
    pub(crate) name: String,
    pub(crate) family: Family,
    pub(crate) size: [usize; 2],
    /// Whether the channels differ.
    pub(crate) colour: bool,
    pub(crate) paper: Fill,
    pub(crate) layers: Vec<Layer>,
    /// Whether the layers lie beside one another on the paper, none over another. Then two that share a cell fill it
    /// without the paper between them.
    pub(crate) side_by_side: bool,
    pub(crate) curves: Vec<Curve>,
    pub(crate) corners: Vec<P>,
    pub(crate) junctions: Vec<Junction>,
    /// How near a traced line must be for a true point to count as found, px: 1, less where true contours are closer.
    pub(crate) tolerance: f64,
}

impl Scene {
    /// An empty sheet of this grey.
    pub(crate) fn new(name: String, family: Family, size: [usize; 2], paper: Fill) -> Self {
        Self {
            name,
            family,
            size,
            colour: false,
            paper,
            layers: Vec::new(),
            side_by_side: false,
            curves: Vec::new(),
            corners: Vec::new(),
            junctions: Vec::new(),
            tolerance: 1.0,
        }
    }

    /// The scene with an area painted on it.
    pub(crate) fn paint(mut self, outline: Vec<P>, fill: Fill) -> Self {
        self.layers.push(Layer { outline, fill });
        self
    }

    /// The scene with a true contour whose step is the same all along.
    pub(crate) fn contour(mut self, points: Vec<P>, closed: bool, contrast: f64) -> Self {
        let contrast = vec![contrast; points.len()];
        self.curves.push(Curve { points, closed, contrast });
        self
    }
}
