//! The same seed is the same scene, here and in every version; another seed is another.

use catoptric_scene::family::{
    Arrangement, Corridor, Kissing, Lattice, Placement, Random, Room, Sphereflake,
};
use catoptric_scene::{Draft, Scene, SceneFormat};

/// Each family with a seed, small; Random and Kissing in each of their ways.
fn families(seed: u64) -> [(&'static str, Draft); 9] {
    let random = Random { balls: 20, seed, ..Random::default() };
    let anywhere = Random { placement: Placement::Anywhere, ..random };
    let kissing = Kissing { seed, ..Kissing::default() };
    let ring = Kissing { arrangement: Arrangement::Ring, spheres: 7, ..kissing };
    let chain = Kissing { arrangement: Arrangement::Chain, ..kissing };
    [
        ("corridor", Corridor { seed, ..Corridor::default() }.draft()),
        ("room", Room { seed, ..Room::default() }.draft()),
        ("kissing", kissing.draft()),
        ("ring", ring.draft()),
        ("chain", chain.draft()),
        ("random", random.draft()),
        ("anywhere", anywhere.draft()),
        ("lattice", Lattice { edge: 2, seed, ..Lattice::default() }.draft()),
        ("sphereflake", Sphereflake { levels: 2, seed, ..Sphereflake::default() }.draft()),
    ]
    .map(|(name, draft)| (name, draft.expect("in range")))
}

/// FNV-1a of the scene's text, which holds every bit of its numbers.
fn hash(draft: Draft) -> u64 {
    let text = Scene::new(draft).expect("valid").to_text(SceneFormat::Toml);
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

#[test]
fn scenes_never_change() {
    let recorded: [[u64; 2]; 9] = RECORDED;
    let now: Vec<[u64; 2]> = families(0)
        .into_iter()
        .zip(families(u64::MAX))
        .map(|((_, first), (_, last))| [hash(first), hash(last)])
        .collect();
    for ((name, _), (now, recorded)) in families(0).iter().zip(now.iter().zip(&recorded)) {
        assert_eq!(now, recorded, "{name}: a published scene changed; all now: {now:#x?}");
    }
}

/// Seeds 0 and 2^64 - 1, in the order of [`families`].
const RECORDED: [[u64; 2]; 9] = [[0; 2]; 9];

#[test]
fn another_seed_is_another_scene() {
    let seeds = [0, 1, 2, 1 << 32, u64::MAX];
    for (i, a) in seeds.into_iter().enumerate() {
        for ((name, first), (_, again)) in families(a).into_iter().zip(families(a)) {
            assert_eq!(first, again, "{name} {a}");
        }
        for b in seeds[..i].iter().copied() {
            for ((name, first), (_, other)) in families(a).into_iter().zip(families(b)) {
                assert_ne!(first, other, "{name} {a} {b}");
            }
        }
    }
}
