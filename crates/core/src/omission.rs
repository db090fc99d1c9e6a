//! Work that is left out because no bit depends on it.

/// Work that need not be done. None of it changes a bit of the picture or a ray count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Omission {
    /// Spheres wholly inside another one are not tested, by any ray.
    ///
    /// Robust numerics, no plane, and the eye outside the outer sphere. A ray would meet that one
    /// first: `plan/nested.rs` asks for a gap between them that is above all rounding.
    Nested,
    /// Primitives that no eye ray of a tile can meet are not tested there, and a tile without
    /// any is filled with the background.
    ///
    /// Robust numerics. The rays would miss them: `cull/tile.rs` bounds their directions by cones,
    /// with margins above all rounding.
    Tiles,
    /// Primitives that cannot stand between a light and any of a tile's points on one primitive
    /// are not tested on the way to the light.
    ///
    /// Robust numerics. The shadow test would be false: `cull/shadow.rs` bounds those ways by a
    /// capsule, and from each packet of points by a cone, with margins above all rounding.
    Occluders,
    /// Without a highlight and without a mirror to follow, no reflected direction is formed, and
    /// without a highlight no power.
    ///
    /// The recursion adds 0 · power, which is 0, and no light is -0.
    Directions,
    /// Shadow rays from a primitive that sends back no light, kd·colour and ks being 0, are
    /// counted and not traced.
    ///
    /// The recursion adds I · (0 · n·l + 0 · power), which is 0: n·l, power and I are finite.
    Shadows,
}

impl Omission {
    /// Every one.
    pub const ALL: [Self; 5] =
        [Self::Nested, Self::Tiles, Self::Occluders, Self::Directions, Self::Shadows];

    /// A word for tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Nested => "nested",
            Self::Tiles => "tiles",
            Self::Occluders => "occluders",
            Self::Directions => "directions",
            Self::Shadows => "shadows",
        }
    }

    /// What is not done, in a sentence.
    #[must_use]
    pub fn what(self) -> &'static str {
        match self {
            Self::Nested => "no ray tries a sphere wholly inside another one",
            Self::Tiles => "eye rays do not try what their tile of pixels cannot show",
            Self::Occluders => "shadow rays do not try what cannot stand in their way",
            Self::Directions => {
                "no mirrored direction where neither highlight nor mirror needs one"
            }
            Self::Shadows => "no shadow ray where a surface sends back no light's light",
        }
    }

    /// Why no bit of the picture depends on it.
    #[must_use]
    pub fn why(self) -> &'static str {
        match self {
            Self::Nested => "whatever comes near it meets the outer one first",
            Self::Tiles => "cones around them miss it, with room for all rounding",
            Self::Occluders => "bounds around the way miss it, with room for all rounding",
            Self::Directions | Self::Shadows => "what would be added is 0, and no light is -0",
        }
    }
}

/// A set of omissions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Omissions(u8);

impl Omissions {
    /// No omission: all work is done.
    pub const NONE: Self = Self(0);

    /// Whether an omission is made.
    #[inline(always)]
    #[must_use]
    pub fn contains(self, omission: Omission) -> bool {
        self.0 & Self::bit(omission) != 0
    }

    /// These, without one.
    #[must_use]
    pub fn without(self, omission: Omission) -> Self {
        Self(self.0 & !Self::bit(omission))
    }

    /// The omissions of the set, in the order of [`Omission::ALL`].
    pub fn iter(self) -> impl Iterator<Item = Omission> {
        Omission::ALL.into_iter().filter(move |&omission| self.contains(omission))
    }

    #[inline(always)]
    fn bit(omission: Omission) -> u8 {
        1 << omission as u8
    }
}

impl FromIterator<Omission> for Omissions {
    fn from_iter<I: IntoIterator<Item = Omission>>(omissions: I) -> Self {
        Self(omissions.into_iter().fold(0, |bits, omission| bits | Self::bit(omission)))
    }
}

#[cfg(test)]
mod tests {
    use super::{Omission, Omissions};

    /// Every set, as a list.
    fn lists() -> impl Iterator<Item = Vec<Omission>> {
        let chosen = |set: u32| move |&of: &Omission| set >> of as u32 & 1 != 0;
        (0..1 << Omission::ALL.len())
            .map(move |set| Omission::ALL.into_iter().filter(chosen(set)).collect())
    }

    #[test]
    fn a_set_is_its_list() {
        assert_eq!(lists().next().map(Omissions::from_iter), Some(Omissions::NONE));
        assert_eq!(Omissions::default(), Omissions::NONE);
        for list in lists() {
            // Neither the order of what is put in counts, nor how often.
            let set: Omissions = list.iter().rev().chain(&list).copied().collect();
            assert_eq!(set.iter().collect::<Vec<_>>(), list);
            for of in Omission::ALL {
                assert_eq!(set.contains(of), list.contains(&of), "{of:?} of {list:?}");
                let rest: Vec<_> = list.iter().copied().filter(|&other| other != of).collect();
                assert_eq!(set.without(of), rest.iter().copied().collect(), "{of:?} of {list:?}");
                assert_eq!(set.without(of).iter().collect::<Vec<_>>(), rest);
            }
        }
    }

    #[test]
    fn no_two_sets_are_equal() {
        let sets: Vec<Omissions> = lists().map(Omissions::from_iter).collect();
        for (i, a) in sets.iter().enumerate() {
            assert_eq!(sets.iter().position(|b| a == b), Some(i));
        }
    }

    #[test]
    fn each_omission_has_words_of_its_own() {
        for a in Omission::ALL {
            let same = |b: &&Omission| b.name() == a.name() || b.what() == a.what();
            assert_eq!(Omission::ALL.iter().filter(same).count(), 1, "{}", a.name());
            assert!(!a.why().is_empty());
        }
    }
}
