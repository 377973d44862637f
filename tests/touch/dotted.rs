//! Can a fingertip tell the textures of dots, as profiles ship them? On embossers and pins every colour, in braille cells
//! some. `cargo run --release -p tactograph-tools --bin touch -- --dots PROFILE` prints the same for more scenes.

use tactograph::internals::dots::textures::carried;
use tactograph::internals::output::svg;
use tactograph::internals::page::{Class, Palette};
use tactograph::internals::profile::Profile;
use tactograph::internals::touch::Ink;
use tactograph_tools::touch::dots::Device;
use tactograph_tools::touch::judge::{self, Tally};
use tactograph_tools::touch::scenes::{self, FINE_PX};

/// What must be read right on the pages of a profile.
struct Wanted {
    profile: &'static str,
    /// Its pitch, mm; the profile's own or another that the device has.
    pitch: &'static str,
    /// For each fingertip, mm, the least share of areas, of grey among them, and of samples: as measured, less a margin. The
    /// finest one is left out where it feels single dots.
    fingers: &'static [(f32, [f32; 3])],
    /// Kinds of scenes and their seeds.
    scenes: &'static [(usize, u64)],
}

const DEVICES: [Wanted; 6] = [
    Wanted {
        profile: "index-basic-d",
        pitch: "2.5",
        fingers: &[(1.0, [0.9, 0.98, 0.98]), (1.5, [0.9, 0.92, 0.97])],
        scenes: &[(1, 0), (2, 1000), (3, 1000)],
    },
    Wanted {
        profile: "index-basic-d",
        pitch: "2.0",
        fingers: &[(1.0, [0.96, 0.8, 0.98]), (1.5, [0.91, 0.76, 0.97])],
        scenes: &[(2, 0), (3, 1000)],
    },
    Wanted {
        profile: "index-basic-d",
        pitch: "1.6",
        fingers: &[(0.5, [0.98, 0.98, 0.98]), (1.0, [0.98, 0.98, 0.98]), (1.5, [0.98, 0.95, 0.97])],
        scenes: &[(2, 1000)],
    },
    Wanted {
        profile: "viewplus-columbia",
        pitch: "1.27",
        fingers: &[(0.5, [0.98, 0.98, 0.98]), (1.0, [0.98, 0.98, 0.98]), (1.5, [0.98, 0.95, 0.97])],
        scenes: &[(2, 1000)],
    },
    Wanted {
        profile: "braillerap",
        pitch: "2.5",
        fingers: &[(0.5, [0.97, 0.98, 0.98]), (1.0, [0.98, 0.98, 0.98]), (1.5, [0.9, 0.85, 0.95])],
        scenes: &[(2, 1000)],
    },
    Wanted {
        profile: "dot-pad",
        pitch: "2.5",
        fingers: &[(1.0, [0.95, 0.95, 0.98]), (1.5, [0.95, 0.9, 0.97])],
        scenes: &[(2, 1000)],
    },
];

fn device(profile: &str, pitch: &str) -> Device {
    let mut profile = Profile::named(profile).expect("it is built in");
    profile.set("dots.pitch", pitch).expect("a key of the profile");
    // cells come without, for the reason that is tested here
    profile.set("figure.textures", "true").expect("a key of the profile");
    Device::of(&profile).expect("it is one of dots")
}

/// What is felt of scenes on a device with a fingertip.
fn felt(device: &Device, scenes: &[(usize, u64)], fingers: &[f32]) -> Vec<Tally> {
    let mut tallies = vec![Tally::default(); fingers.len()];
    for &(kind, seed) in scenes {
        for (scene, page) in device.pages_of(&scenes::scene(kind, seed, FINE_PX)) {
            let ink = Ink::of(&svg::write(&page)).expect("a page is a page");
            for (tally, finger) in tallies.iter_mut().zip(fingers) {
                tally.add(&judge::judge(&scene, &page, &ink.felt(*finger).expect("there is such a finger")));
            }
        }
    }
    tallies
}

/// What is read worse on the scenes than is wanted.
fn faults(wanted: &Wanted) -> Vec<String> {
    let device = device(wanted.profile, wanted.pitch);
    let fingers: Vec<f32> = wanted.fingers.iter().map(|(finger, _)| *finger).collect();
    let mut faults = Vec::new();
    for (sum, (finger, [areas, grey, _])) in felt(&device, wanted.scenes, &fingers).iter().zip(wanted.fingers) {
        let (classes, grey_only, white_only) = (judge::CLASSES, judge::only(Some(Class::Grey)), judge::only(None));
        let parts =
            [("areas", classes, 5000, *areas), ("grey", grey_only, 300, *grey), ("white", white_only, 300, 1.0)];
        for (what, classes, places, least) in parts {
            let (judged, share) = sum.share(classes);
            if judged < places || share < least {
                let told = format!("{} at {} mm, a fingertip of {finger} mm", wanted.profile, wanted.pitch);
                faults.push(format!("{told}: {share} of {what}, {judged} places, {:?}", sum.felt));
            }
        }
    }
    faults
}

#[test]
fn colours_are_read_right_on_embossers_and_pins() {
    let faults: Vec<String> = std::thread::scope(|scope| {
        let work = DEVICES.each_ref().map(|wanted| scope.spawn(|| faults(wanted)));
        work.into_iter().flat_map(|work| work.join().expect("every scene has a page")).collect()
    });
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn braille_cells_carry_blue_yellow_and_grey_and_say_so() {
    let cells = device("braille-cells", "2.34");
    let (green, red, grey) = (Class::Green, Class::Red, Class::Grey);
    assert_eq!(carried(&Palette::PAPER, &cells.area), Err(vec![(green, red), (green, grey), (red, grey)]));
    let sum = felt(&cells, &[(0, 0), (0, 1000)], &[1.0])[0];
    for (index, class) in Class::ALL.iter().enumerate() {
        let share = sum.share(index..index + 1).1;
        // measured 0.70, 0.03, 0.81, 0.10 and 0.96
        let holds = if *class == green || *class == red { share < 0.2 } else { share >= 0.65 };
        assert!(holds, "{class:?}: {share} is read right, {:?}", sum.felt);
    }
}

#[test]
fn each_pattern_is_read_right_at_every_density_and_lightness() {
    std::thread::scope(|scope| DEVICES.iter().for_each(|wanted| drop(scope.spawn(|| hold_samples(wanted)))));
}

fn hold_samples(wanted: &Wanted) {
    let device = device(wanted.profile, wanted.pitch);
    let amounts = [(0.0, 0.88), (0.3, 0.1), (1.0, 0.1)];
    for (class, (density, lightness)) in Class::ALL.into_iter().flat_map(|class| amounts.map(|of| (class, of))) {
        let (page, place) = device.page_of_sample(class, lightness, density, 40.0);
        let ink = Ink::of(&svg::write(&page)).expect("a page is a page");
        for (finger, [.., least]) in wanted.fingers {
            let share = judge::share_of_sample(class, &ink.felt(*finger).expect("there is such a finger"), place);
            let told = format!("{} at {} mm, {class:?}, density {density}", wanted.profile, wanted.pitch);
            assert!(share >= *least, "{told}, lightness {lightness}, fingertip {finger} mm: {share} is read right");
        }
    }
}
