//! Faults that are put into a list of contacts: of an exact answer that is judged, or of the witness from which the certificate
//! of another answer is proven. Only places count.

use palkki::state::Contact;

/// A fault in a list of contacts.
#[derive(Debug, Clone, Copy)]
pub struct ContactFault {
    /// What it is, in words.
    pub name: &'static str,
    /// Whether it has a size, one of [`SIZES`](super::SIZES).
    pub sized: bool,
    act: fn(&mut Vec<Contact>, f64, f64),
}

impl ContactFault {
    /// The contacts with the fault in them, on a beam of some length; nothing if they are the same as before.
    #[must_use]
    pub fn put_into(&self, contacts: &[Contact], size: f64, length: f64) -> Option<Vec<Contact>> {
        let mut broken = contacts.to_vec();
        (self.act)(&mut broken, size, length);
        // What is no number differs from itself.
        #[expect(clippy::float_cmp, reason = "the same places, to the bit, are no fault")]
        let same = broken.len() == contacts.len()
            && broken.iter().zip(contacts).all(|(a, b)| a.from == b.from && a.to == b.to);
        (!same).then_some(broken)
    }
}

/// Every fault in some sizes, with the contacts that have it; without those that change nothing.
pub fn every_contact_fault<'a>(
    contacts: &'a [Contact],
    length: f64,
    sizes: &'a [f64],
) -> impl Iterator<Item = (ContactFault, f64, Vec<Contact>)> + 'a {
    let sized = move |fault: ContactFault| if fault.sized { sizes } else { &[0.0] };
    let all = CONTACT_FAULTS.into_iter().flat_map(move |fault| sized(fault).iter().map(move |&size| (fault, size)));
    all.filter_map(move |(fault, size)| Some((fault, size, fault.put_into(contacts, size, length)?)))
}

fn first(contacts: &mut [Contact], act: impl FnOnce(&mut Contact)) {
    if let Some(contact) = contacts.first_mut() {
        act(contact);
    }
}

const fn sized(name: &'static str, act: fn(&mut Vec<Contact>, f64, f64)) -> ContactFault {
    ContactFault { name, sized: true, act }
}

const fn whole(name: &'static str, act: fn(&mut Vec<Contact>, f64, f64)) -> ContactFault {
    ContactFault { name, sized: false, act }
}

/// All of them.
pub const CONTACT_FAULTS: [ContactFault; 14] = [
    sized("the first place moved to the right, by a share of the length", |contacts, size, length| {
        first(contacts, |c| {
            let point = c.to <= c.from;
            c.from = (c.from + size * length).min(length);
            c.to = if point { c.from } else { c.to };
        });
    }),
    sized("all places moved to the right", |contacts, size, length| {
        contacts.iter_mut().for_each(|c| {
            c.from = (c.from + size * length).min(length);
            c.to = (c.to + size * length).min(length);
        });
    }),
    sized("a point made a zone", |contacts, size, length| {
        if let Some(point) = contacts.iter_mut().find(|c| c.to <= c.from) {
            point.from = (point.from - size * length).max(0.0);
            point.to = (point.to + size * length).min(length);
        }
    }),
    sized("a zone made shorter at its left end", |contacts, size, length| {
        if let Some(zone) = contacts.iter_mut().find(|c| c.from < c.to) {
            zone.from = (zone.from + size * length).min(zone.to);
        }
    }),
    sized("a contact added beside the first", |contacts, size, length| {
        if let Some(first) = contacts.first().copied() {
            contacts.insert(0, Contact::at((first.from - size * length).max(0.0), first.force));
        }
    }),
    whole("a contact added half way to the first", |contacts, _, length| {
        let first = contacts.first().map_or(length, |c| c.from);
        contacts.insert(0, Contact::at(0.5 * first, 1.0));
    }),
    whole("the first two contacts merged", |contacts, _, _| {
        if let [first, second, ..] = contacts[..] {
            contacts.splice(..2, [Contact { to: second.to, ..first }]);
        }
    }),
    whole("zones made points at their ends", |contacts, _, _| {
        let ends = |c: &Contact| if c.from < c.to { vec![c.from, c.to] } else { vec![c.from] };
        *contacts = contacts.iter().flat_map(ends).map(|x| Contact::at(x, 1.0)).collect();
    }),
    whole("the first contact dropped", |contacts, _, _| {
        if !contacts.is_empty() {
            contacts.remove(0);
        }
    }),
    whole("all contacts dropped", |contacts, _, _| contacts.clear()),
    whole("all contacts one zone", |contacts, _, _| {
        if let (Some(first), Some(last)) = (contacts.first().copied(), contacts.last().copied()) {
            *contacts = vec![Contact { to: last.to, ..first }];
        }
    }),
    whole("turned round", |contacts, _, length| {
        contacts.reverse();
        contacts.iter_mut().for_each(|c| (c.from, c.to) = (length - c.to, length - c.from));
    }),
    whole("a place that is NaN", |contacts, _, _| first(contacts, |c| (c.from, c.to) = (f64::NAN, f64::NAN))),
    whole("a place that is infinite", |contacts, _, _| first(contacts, |c| c.to = f64::INFINITY)),
];
