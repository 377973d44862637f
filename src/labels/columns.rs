//! Words one below the other that have no room all in one form, as the names beside a diagram: each as it fits.

use super::candidates::Candidate;
use super::context::{ALONG, Context, REACH, both_ways, is_free};
use super::groups::{Group, GroupDirection};
use super::placed::{Attachment, PlacedAs};
use super::spacing::Spacing;
use crate::units::{MmPoint, MmRect};

/// Words of a column at the nearest edge at which most are written in full, in one line or two, and at most one or two
/// are abbreviated, as those alone would have no room. Numbers and months are all in one form, which says that they are
/// one series.
pub(super) fn each_as_it_fits(
    group: &Group,
    context: &Context<'_>,
    others: &[Option<Candidate>],
) -> Option<Vec<Candidate>> {
    let GroupDirection::Column(edge) = group.lies else { return None };
    if group.steps.is_some() || group.is_of_months {
        return None;
    }
    let step = context.params.step;
    let members = &group.members;
    let middle = |i: usize| context.wanted[members[i]].anchor.center().y;
    let is_short = |label: usize, form: usize| {
        context.forms[label].as_ref().is_ok_and(|forms| forms.forms[form].abbreviation.is_some())
    };
    let at = |offset: f32| {
        let mut found: Vec<Candidate> = Vec::with_capacity(members.len());
        for (i, &label) in members.iter().enumerate() {
            let next = [i.checked_sub(1), (i + 1 < members.len()).then_some(i + 1)].into_iter().flatten();
            let next = next.map(|other| (middle(other) - middle(i)).abs()).fold(f32::INFINITY, f32::min);
            let moves = (ALONG * next.min(REACH) / step) as i32;
            let forms = context.forms[label].as_ref().ok()?.forms.iter().enumerate();
            let mut places = forms.filter(|(_, form)| form.kind.is_of_one()).flat_map(|(number, form)| {
                let size = form.extent(context.cells);
                let left = edge.left_of(context.wanted[label].anchor, size.x) + offset;
                both_ways(0, moves).map(move |moved| {
                    let corner = MmPoint::new(left, middle(i) - 0.5 * size.y + moved as f32 * step);
                    let place = context.cells.snapped(MmRect::new(corner, corner + size));
                    let cost = form.kind.cost() + offset.abs() + (moved as f32 * step).abs();
                    Candidate::of_row(number, place, Attachment::Beside, cost, PlacedAs::InRow)
                })
            });
            found.push(places.find(|candidate| {
                let mut others = found.iter().chain(others.iter().flatten());
                is_free(label, candidate, context)
                    && others.all(|other| {
                        !candidate.is_too_near(other, Spacing::least_rounded(context.cells), context.params.leader_off)
                    })
            })?);
        }
        let short = members.iter().zip(&found).filter(|(label, of)| is_short(**label, of.form)).count();
        (short <= MOST_SHORT && 2 * short < members.len()).then_some((short, found))
    };
    let offsets = both_ways(0, (REACH / step).ceil() as i32).map(|offset| offset as f32 * step);
    offsets.filter_map(at).min_by_key(|(short, _)| *short).map(|(_, found)| found)
}

/// Most words of a column that are abbreviated where the others are not.
const MOST_SHORT: usize = 2;
