//! The same scenes as pages of dots, as profiles ship them: can a fingertip tell the colours?
//!
//! Every page comes out of the pipeline with a profile of dots, so grid, diameter, heights, lines and gaps are what is pressed.
//! A scene has one size in millimetres; where a device is smaller, such as a pin display, it comes in parts, a page each.

use std::sync::Arc;

use tactograph::Page;
use tactograph::internals::devices::DotArea;
use tactograph::internals::dots::textures::{self, Params};
use tactograph::internals::page::layout::{self, Layout};
use tactograph::internals::page::{Class, Figure, Medium, Parts};
use tactograph::internals::pipeline::{Fit, Request};
use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::units::{MmPoint, MmRect, Size};

use super::scenes::{SIDE_MM, Scene};

/// A profile of dots.
pub struct Device {
    plan: Plan,
    /// Where it can put dots.
    pub area: DotArea,
    /// Its textures.
    pub params: Params,
    sheet: [f32; 2],
    /// Parts of a scene along each side.
    parts: usize,
}

impl Device {
    /// The device of a profile; none if it is not one of dots.
    pub fn of(profile: &Profile) -> Option<Self> {
        let mut profile = profile.clone();
        // it has a sheet to itself, and is not felt here
        profile.set("overview", "false").expect("a key of the profile");
        // all of a scene is judged, also what would be the ground of a picture
        profile.set("figure.ground", "true").expect("a key of the profile");
        let plan = Plan::new(&profile).expect("the values make sense");
        let Layout { figure, medium, sheet, .. } = layout::fit(1.0, f32::MAX, &plan.layout());
        let Medium::Dots(medium) = medium else { return None };
        let params = plan.dot_textures(&medium);
        let parts = (SIDE_MM as f32 / figure.width()).ceil() as usize;
        Some(Self { plan, area: medium.area, params, sheet, parts })
    }

    /// The pages of a scene at its size, each with the part of the scene that is on it.
    pub fn pages_of(&self, scene: &Scene) -> Vec<(Scene, Page)> {
        let width = SIDE_MM as f32 / self.parts as f32;
        let pages = scene.parts(self.parts).into_iter().map(|part| {
            let page = self.page_of(&part.picture, Some(width));
            (part, page)
        });
        pages.collect()
    }

    /// The page of a picture, so many millimetres wide or as large as it can be.
    pub fn page_of(&self, picture: &[u8], width: Option<f32>) -> Page {
        let fonts = || Arc::new(usvg::fontdb::Database::new());
        let fit = Fit { width, ..Fit::default() };
        let request = Request {
            plan: &self.plan,
            limits: Default::default(),
            fonts: &fonts,
            title: "scene",
            language: "en",
            fit,
            cancelled: &|| false,
        };
        tactograph::internals::pipeline::convert(picture, &request, &mut |_| ())
            .expect("a picture can be converted")
            .page
    }

    /// One texture on a square of the sheet, and where it lies: in the middle, with sides of `side` mm.
    pub fn page_of_sample(&self, class: Class, lightness: f32, density: f32, side: f32) -> (Page, MmRect) {
        let middle = self.area.bounds().center();
        let half = MmPoint::new(0.5 * side, 0.5 * side).to_vector();
        let place = MmRect::new(middle - half, middle + half);
        let texture = textures::sample(class, lightness, density, place, &self.area, &self.params);
        let figure = Figure { place, source: Size::new(1, 1), textures: vec![texture], lines: Vec::new() };
        let parts = Parts { title: "dots".into(), ..Parts::of(self.sheet, figure) };
        (Page::new(parts).expect("all dots lie on the sheet"), place)
    }
}
