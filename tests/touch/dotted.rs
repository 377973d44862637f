//! Can a fingertip tell the textures of dots? On even grids and on free paper every colour, in braille cells some.

use crate::dots::Device;
use crate::judge::{self, Tally};
use crate::scenes::{self, FINE_PX, KINDS};
use crate::{FINGERS, page_of};
use tactograph::dots::textures::carried;
use tactograph::output::svg;
use tactograph::page::{Class, Palette};
use tactograph::profile::{Plan, Profile};
use tactograph::touch::Ink;
use tactograph::units::{MmPoint, MmRect};

/// Devices with the shares of areas that must be read right by the three fingertips. On coarse grids diagonal rows are single
/// dots to the finest one.
const DEVICES: [(&str, [f32; 3]); 5] = [
    ("1.27", [0.98, 0.98, 0.97]),
    ("1.6", [0.98, 0.98, 0.97]),
    ("2.0", [0.0, 0.98, 0.97]),
    ("2.5", [0.0, 0.98, 0.97]),
    ("free", [0.98, 0.98, 0.95]),
];

fn device(name: &str) -> Device {
    Device::named(name).expect("the test names what there is")
}

/// What is felt of the scenes of a kind with these seeds on each device.
fn felt(kind: usize, seeds: &[u64], devices: &[Device]) -> Vec<[Tally; 3]> {
    let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it makes sense");
    let mut tallies = vec![[Tally::default(); 3]; devices.len()];
    for &seed in seeds {
        let scene = scenes::scene(kind, seed, FINE_PX);
        let swell = page_of(&scene, &[]);
        for (tallies, device) in tallies.iter_mut().zip(devices) {
            let page = device.page_of(&scene.picture, &swell, &plan);
            let ink = Ink::of(&svg::write(&page)).expect("a page is a page");
            for (tally, finger) in tallies.iter_mut().zip(FINGERS) {
                tally.add(&judge::judge(&scene, &page, &ink.felt(finger).expect("there is such a finger")));
            }
        }
    }
    tallies
}

/// The same of all kinds of scenes.
fn felt_of_all(seeds: &[u64], devices: &[Device]) -> Vec<[Tally; 3]> {
    let mut sums = vec![[Tally::default(); 3]; devices.len()];
    std::thread::scope(|scope| {
        let work: Vec<_> = (0..KINDS.len()).map(|kind| scope.spawn(move || felt(kind, seeds, devices))).collect();
        for tallies in work.into_iter().map(|work| work.join().expect("no scene fails")) {
            for (sums, tallies) in sums.iter_mut().zip(&tallies) {
                sums.iter_mut().zip(tallies).for_each(|(sum, tally)| sum.add(tally));
            }
        }
    });
    sums
}

#[test]
fn colours_are_read_right_on_embossers() {
    let devices = DEVICES.map(|(name, _)| device(name));
    for seed in [0, 1000] {
        for ((name, wanted), sums) in DEVICES.iter().zip(felt_of_all(&[seed], &devices)) {
            for ((sum, least), finger) in sums.iter().zip(wanted).zip(FINGERS) {
                let told = format!("{name}, seed {seed}, a fingertip of {finger} mm: {:?}", sum.felt);
                let (judged, areas) = sum.share(0..5);
                assert!(judged > 20_000, "too little is judged, {told}");
                assert!(areas >= *least, "{areas} of the areas, {told}");
                assert!(sum.share(4..5).1 >= 0.9, "{} of grey, {told}", sum.share(4..5).1);
                assert!(sum.share(5..6).1 >= 1.0, "{} of white, {told}", sum.share(5..6).1);
            }
        }
    }
}

#[test]
fn braille_cells_carry_blue_yellow_and_grey_and_say_so() {
    let cells = device("cells");
    let (green, red, grey) = (Class::Green, Class::Red, Class::Grey);
    assert_eq!(carried(&Palette::PAPER, &cells.room), Err(vec![(green, red), (green, grey), (red, grey)]));
    let [_, sum, _] = felt(0, &[0, 1000], &[cells])[0];
    for (index, class) in Class::ALL.iter().enumerate() {
        let share = sum.share(index..index + 1).1;
        let carried = *class != green && *class != red;
        assert!((share > 0.9) == carried, "{class:?}: {share} is read right, {:?}", sum.felt);
    }
}

#[test]
fn each_pattern_is_read_right_at_every_density_and_lightness() {
    let place = MmRect::new(MmPoint::new(20.0, 20.0), MmPoint::new(70.0, 70.0));
    for (name, wanted) in DEVICES {
        let device = device(name);
        for class in Class::ALL {
            for (density, lightness) in [0.0, 0.3, 1.0].into_iter().flat_map(|d| [0.88, 0.1].map(|l| (d, l))) {
                let sample = device.page_of_sample(class, lightness, density, place);
                let ink = Ink::of(&svg::write(&sample)).expect("a page is a page");
                for (finger, least) in FINGERS.into_iter().zip(wanted) {
                    let felt = ink.felt(finger).expect("there is such a finger");
                    let share = judge::share_of_sample(class, &felt, place);
                    let told = format!("{name}, {class:?}, density {density}, lightness {lightness}");
                    assert!(share >= least, "{told}, fingertip {finger} mm: {share} is read right");
                }
            }
        }
    }
}
