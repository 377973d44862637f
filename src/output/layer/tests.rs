//! Tests of `layer`.

use super::*;

#[test]
fn ids_are_those_that_other_programs_rely_on() {
    let id_and_label = |layer: Layer| (layer.id(), layer.label());
    assert_eq!(id_and_label(Layer::Texture(Class::Blue)), ("texture-blue".into(), "Texture blue".into()));
    assert!(Layer::all().all(|layer| Layer::named(&layer.id()) == Some(layer)));
    assert!(Layer::all().all(|layer| Layer::named(&layer.label()) == Some(layer)));
    assert_eq!(Layer::named("sky"), None);
    assert_eq!(id_and_label(Layer::OverviewFrame), ("overview-frame".into(), "Overview frame".into()));
}
