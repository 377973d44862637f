//! Why something is not on a page or is there otherwise than it looks, for programs.

use super::harm::Harm;

/// `Reason`, `Reason::ALL`, `Reason::name` and `Reason::harm` from one table, so that none of them lacks a reason: its
/// name, and what it means for the reader.
macro_rules! reasons {
    ($($(#[doc = $doc:literal])+ $case:ident => $name:literal, $harm:ident;)+) => {
        /// Why a remark of the kinds `left-out`, `not-on-page`, `taken-as`, `faulty`, `labels-left-out`, `no-key`,
        /// `no-subject` and `not-in-png` is made, for programs: its sentence may change, and this stays. Remarks of one
        /// kind and reason that are about the same say the same, but for names, numbers and places, and but for what
        /// helps against several, and from where places are counted: the first of a page says these.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Reason {
            $($(#[doc = $doc])+ $case,)+
        }

        impl Reason {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$case),+];

            /// Its name, such as "off-sheet".
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$case => $name,)+
                }
            }

            /// What it means for the reader.
            pub(super) fn harm(self) -> Harm {
                match self {
                    $(Self::$case => Harm::$harm,)+
                }
            }
        }
    };
}

reasons! {
    // of the file of a picture
    /// A picture inside a drawing has more pixels than the limit.
    OverLimit => "over-limit", ThingsMissing;
    /// A picture inside a drawing or a document cannot be read.
    Unreadable => "unreadable", ThingsMissing;
    /// A document does not say which letters it has.
    UnknownLetters => "unknown-letters", ThingsMissing;
    /// Texts of a drawing are not seen in it.
    NotSeen => "not-seen", Little;
    /// A drawing has more paths than its lines are taken from: they are found in its pixels.
    ManyPaths => "many-paths", Changed;
    /// A form field or a remark of a document does not say what it looks like.
    NoAppearance => "no-appearance", ThingsMissing;
    /// Of the same kinds there is more, which is not named.
    AndMore => "and-more", ThingsMissing;
    // of a page that was read
    /// Pictures of pixels in a file have no lines.
    Pixels => "pixels", ThingsMissing;
    /// What an object shows is in another file, or is no SVG.
    Elsewhere => "elsewhere", ThingsMissing;
    /// The layer of the figure is gone, so that its place is not known.
    NoFigure => "no-figure", Wrong;
    /// A page does not say how it was made, and is taken as one of the default profile.
    NoMetadata => "no-metadata", Changed;
    /// A page does not say how large its sheet is.
    NoSize => "no-size", Changed;
    /// Marks lie beyond the sheet.
    OffSheet => "off-sheet", ThingsMissing;
    /// Clip paths, masks and filters are not taken: what they cut off is there.
    Clipped => "clipped", Wrong;
    /// What is grey, coloured or filled unevenly is taken as black.
    NotBlack => "not-black", Changed;
    /// Marks lie outside of the layers of a page, or of the one that is taken.
    OutsideLayers => "outside-layers", ThingsMissing;
    /// The layer of a texture was renamed to that of another colour.
    LayerRenamed => "layer-renamed", Changed;
    /// A filled shape without the colour of a texture is a line around it.
    NoTextureColour => "no-texture-colour", Changed;
    /// A filled shape lies in a layer that has no textures and is a line around it.
    NoTexturesThere => "no-textures-there", Changed;
    /// A shape among textures is neither rhombus nor dot.
    NoSign => "no-sign", PartsMissing;
    /// A shape in the layer of words in print is no word.
    NoPrintWord => "no-print-word", Little;
    /// What is white prints nothing and covers nothing.
    White => "white", Changed;
    /// Dots of one group have several sizes and are taken as of one.
    UnevenDotSizes => "uneven-dot-sizes", Changed;
    /// Signs of several kinds are points on the page, some filled and some hollow, or all alike.
    SignsOfKinds => "signs-of-kinds", Changed;
    /// Dashed lines have no gaps on the page.
    Dashed => "dashed", Changed;
    /// Fingers read no letters in print.
    PrintLetters => "print-letters", ThingsMissing;
    /// What a page says of its profile is not taken as a whole.
    ProfileOfPage => "profile-of-page", Changed;
    /// The page that was read is mirrored and is turned back for paper, or is mirrored and so has no words in print.
    Mirrored => "mirrored", Changed;
    /// Lines lie outside of the figure.
    OutsideFigure => "outside-figure", PartsMissing;
    /// Lines that were drawn on a page of dots are dots now.
    StrokesAsDots => "strokes-as-dots", Changed;
    /// Widths of lines are brought into the range of the profile.
    WidthOutOfRange => "width-out-of-range", Little;
    /// Dots that were drawn by hand stay only on the page's own paper or device.
    DotsByHand => "dots-by-hand", ThingsMissing;
    /// A sheet of a set has no ticks in another size.
    SheetOfSet => "sheet-of-set", Changed;
    /// Braille is too near to other marks, or its cells are not those of its text.
    BrailleFaulty => "braille-faulty", Wrong;
    /// The key that was made with the page no longer fits it.
    KeyOutdated => "key-outdated", Wrong;
    /// What a sheet of a key has beside colours and abbreviations is not taken.
    NotOfKey => "not-of-key", ThingsMissing;
    /// Words that were moved have their places anew on another paper or device.
    PlacedAnew => "placed-anew", Changed;
    /// The title in braille is as it was, and the page has another title.
    TitleStays => "title-stays", Changed;
    /// The overview is as it was, and the figure is not.
    OverviewStays => "overview-stays", InOverview;
    /// The overview is drawn of that of the page that was read, and not of the figure.
    OverviewOfPage => "overview-of-page", InOverview;
    /// There is no overview, so that the words of a table have room.
    OverviewForWords => "overview-for-words", InOverview;
    /// The overview is made anew of lines that are given, and is another one than that of their page.
    OverviewOfLines => "overview-of-lines", InOverview;
    // of what a person gives
    /// Texts were typed: they are written in braille beside their places.
    WrittenBeside => "written-beside", Changed;
    /// Texts were typed: they are labels, which are placed anew.
    TypedAsLabel => "typed-as-label", Changed;
    /// Braille was typed, and is written as typed.
    WrittenAsTyped => "written-as-typed", Changed;
    /// A text was typed outside of the figure, in which labels stand.
    TypedOutside => "typed-outside", Changed;
    /// Braille has no room where it was typed, and stands beside.
    BrailleMoved => "braille-moved", Changed;
    /// Words of a page are not taken where its lines or areas are.
    WordsOfPage => "words-of-page", ThingsMissing;
    /// Areas beside lines that are given are not taken.
    AreasBesideLines => "areas-beside-lines", ThingsMissing;
    /// A page that is given is of a picture of another size.
    OtherPicture => "other-picture", Wrong;
    /// Lines that are given are too short in this figure.
    TooShort => "too-short", ThingsMissing;
    /// In a file that is given as lines there are none.
    NoLinesGiven => "no-lines-given", Empty;
    /// What is given as a picture of lines looks like a photograph.
    NoDrawing => "no-drawing", Empty;
    /// Lines that are found run beside those that were added.
    BesideAdded => "beside-added", Wrong;
    /// An area that was drawn is filled with the texture of its colour.
    AreaFilled => "area-filled", Changed;
    /// An area that was moved to another colour has the texture of that.
    AreaRecoloured => "area-recoloured", Changed;
    /// Areas that were drawn are more than a page takes.
    TooManyAreas => "too-many-areas", ThingsMissing;
    /// An area that was drawn is too light for a colour.
    AreaTooLight => "area-too-light", ThingsMissing;
    /// An area that was drawn or moved lies outside of the figure.
    AreaOutside => "area-outside", ThingsMissing;
    /// An area that was drawn, moved or copied lies under others.
    AreaCovered => "area-covered", ThingsMissing;
    /// An area that was drawn is too narrow for a texture.
    AreaTooNarrow => "area-too-narrow", ThingsMissing;
    /// Subjects are more than a page takes.
    TooManySubjects => "too-many-subjects", ThingsMissing;
    /// Nothing with a clear outline is at the place of a subject.
    NothingThere => "nothing-there", ThingsMissing;
    /// Outlines of regions are off, so that nothing can be named but what closed lines surround.
    RegionsOff => "regions-off", ThingsMissing;
    /// The place of a subject is outside of the part of the picture that is drawn.
    OutsidePart => "outside-part", ThingsMissing;
    /// The figure is narrower than asked for, as a drawing's own words need room beside it.
    NarrowerForWords => "narrower-for-words", Changed;
    /// Texts were read from pixels and should be looked through.
    ReadFromPixels => "read-from-pixels", Changed;
    // of lines
    /// A line has no room as a whole.
    NoRoomForLine => "no-room-for-line", ThingsMissing;
    /// A closed outline is open, as a piece of it has no room.
    OutlineOpen => "outline-open", PartsMissing;
    /// A line is in pieces, as some of it has no room.
    LineInPieces => "line-in-pieces", PartsMissing;
    /// A line ends before another one that it met in the drawing, as it has no room up to it.
    EndsBeforeLine => "ends-before-line", PartsMissing;
    /// A small closed shape has no room.
    NoRoomForShape => "no-room-for-shape", ThingsMissing;
    /// An arrowhead has no room.
    NoRoomForArrowhead => "no-room-for-arrowhead", PartsMissing;
    /// Ticks of a scale have no room.
    NoRoomForTicks => "no-room-for-ticks", PartsMissing;
    /// Ticks and marks of angles are too short for fingers.
    MarksTooShort => "marks-too-short", PartsMissing;
    /// The outline of a subject has no room.
    NoRoomForSubject => "no-room-for-subject", ThingsMissing;
    /// The overview lacks most of the outline that comes first in the figure.
    FirstNotInOverview => "first-not-in-overview", InOverview;
    /// The overview lacks most of the outlines of other large things of the figure.
    ThingNotInOverview => "thing-not-in-overview", InOverview;
    /// The outline of a subject is erased.
    SubjectErased => "subject-erased", ThingsMissing;
    /// Lines of a page are too short for another one or too near to others.
    ShortOrNear => "short-or-near", ThingsMissing;
    /// The grid of squared paper is left out: pieces of it would be felt as lines.
    SquaredGrid => "squared-grid", PartsMissing;
    /// A stroke of another colour lies on a line and is one with it.
    OnOtherLine => "on-other-line", PartsMissing;
    /// The gridlines of a chart are left out, so that its bars have room.
    ChartGrid => "chart-grid", Changed;
    /// Bars of a chart touch, or have a common outline, for want of room.
    BarsJoined => "bars-joined", Changed;
    /// A bar is too low for an outline.
    BarTooLow => "bar-too-low", ThingsMissing;
    /// The outlines of bars have no room as a whole.
    BarTorn => "bar-torn", PartsMissing;
    /// A bar beside an axis is drawn as standing at it.
    BarAtAxis => "bar-at-axis", Changed;
    /// The edges of the paper of a scan are no lines.
    PaperEdge => "paper-edge", Changed;
    /// Fingers feel no colours of lines.
    ColoursOfLines => "colours-of-lines", PartsMissing;
    /// The words of a legend of lines stand at these.
    LegendAtLines => "legend-at-lines", Changed;
    /// Rows of textures lie close beside most of the lines of a page of dots.
    AmongRows => "among-rows", Wrong;
    /// Too many ends of the lines of a photograph lead to nothing.
    LooseEnds => "loose-ends", Wrong;
    // of an overview
    /// Lines of the figure have no room in the overview.
    NoRoomInOverview => "no-room-in-overview", InOverview;
    /// Areas that lines enclose in the figure are open in the overview, or run into others.
    AreaNotInOverview => "area-not-in-overview", InOverview;
    /// Closed lines that a person drew have no room in the overview.
    ByHandNotInOverview => "by-hand-not-in-overview", InOverview;
    /// The overview has no gridlines, which would hide its shapes.
    GridNotInOverview => "grid-not-in-overview", InOverview;
    /// The overview has no leader lines, as it has no words.
    LeadersNotInOverview => "leaders-not-in-overview", InOverview;
    /// Marks of angles are too short in the overview.
    MarksNotInOverview => "marks-not-in-overview", InOverview;
    // of areas
    /// An area is too small for a texture.
    AreaTooSmall => "area-too-small", TexturesMissing;
    /// What is erased leaves too little of an area for a texture.
    AreaCut => "area-cut", TexturesMissing;
    /// No area of a colour is large enough to learn its texture.
    ColourTooSmall => "colour-too-small", TexturesMissing;
    /// Areas have no room for the signs of a texture clear of lines.
    NoRoomForTexture => "no-room-for-texture", TexturesMissing;
    /// Bars of a chart have no room for the signs of a texture clear of lines.
    BarsTooSmall => "bars-too-small", ThingsMissing;
    /// The ground has no texture, so that lines stand out.
    GroundBlank => "ground-blank", Changed;
    /// A label stands in the place of an area's texture.
    UnderLabel => "under-label", TexturesMissing;
    /// Signs of textures are too near to a line or dot that was drawn or moved.
    SignNearLine => "sign-near-line", TexturesMissing;
    /// The legend is in the key, and not in the figure.
    LegendInKey => "legend-in-key", Changed;
    /// A legend of signs is not on the page, where its samples would be felt as points.
    LegendOfSigns => "legend-of-signs", ThingsMissing;
    /// No key tells what the colours of a legend mean.
    LegendWithoutKey => "legend-without-key", ThingsMissing;
    /// A colour of the legend has no texture on the page.
    LegendWithoutTexture => "legend-without-texture", ThingsMissing;
    /// Several colours of the legend have one texture.
    LegendSharesTexture => "legend-shares-texture", ThingsMissing;
    // of words
    /// A label names what is not on the page.
    NamesNothing => "names-nothing", Wrong;
    /// A label stands nearer to what another one names.
    NearerToOther => "nearer-to-other", Wrong;
    /// The leader line of a label crosses other lines.
    CrossesLines => "crosses-lines", Changed;
    /// A leader line of the drawing leads to nothing on the page.
    LeadsToNothing => "leads-to-nothing", Wrong;
    /// A leader line of the drawing has no room as a whole.
    NoRoomForLeader => "no-room-for-leader", PartsMissing;
    /// A heading above the drawing is abbreviated, or has no room.
    HeadingNotInFull => "heading-not-in-full", PartsMissing;
    /// Labels of a row or column stand in the margin.
    InMargin => "in-margin", Little;
    /// Of numbers along an axis only one has the unit.
    OneUnit => "one-unit", Little;
    /// Lowered or raised numbers stand on the line in braille.
    NumbersOnLine => "numbers-on-line", Changed;
    /// Letters stand in braille without their accents, or signs are written in others.
    OtherLetters => "other-letters", Changed;
    /// A formula is written in braille sign by sign, not by the rules of a mathematical code.
    SignBySign => "sign-by-sign", Changed;
    /// There is no room in print beside braille.
    NoRoomForPrint => "no-room-for-print", Little;
    /// Words in print follow their braille, which was moved.
    PrintFollows => "print-follows", Little;
    /// There are no fonts for words in print.
    NoFonts => "no-fonts", ThingsMissing;
    // why labels are left out, or there is no key
    /// A label lies outside of the picture.
    LabelOutside => "label-outside", ThingsMissing;
    /// A label has no room.
    NoRoomForLabel => "no-room-for-label", ThingsMissing;
    /// Of the numbers along an axis there is room for every second, fifth or tenth, or for those at ticks.
    NumbersThinned => "numbers-thinned", Changed;
    /// Labels are more than a page takes.
    TooManyLabels => "too-many-labels", ThingsMissing;
    /// A text is longer than a page takes.
    TextTooLong => "text-too-long", ThingsMissing;
    /// The braille code has no cells for a text.
    NoCells => "no-cells", ThingsMissing;
    /// A text would say something else without the characters that its code lacks.
    Misleading => "misleading", ThingsMissing;
    /// Braille is off.
    BrailleOff => "braille-off", ThingsMissing;
    /// There is no braille code for the language.
    NoCode => "no-code", ThingsMissing;
    /// A key would tell nothing.
    NothingToTell => "nothing-to-tell", Little;
    /// A sheet of a key has no key of its own.
    IsAKey => "is-a-key", Otherwise;
    /// The key that was made with a page is a file of its own.
    KeyInOtherFile => "key-in-other-file", Otherwise;
}

#[cfg(test)]
mod tests;
