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
    let families = families(0).into_iter().zip(families(u64::MAX));
    let now: Vec<_> =
        families.map(|((name, first), (_, last))| (name, hash(first), hash(last))).collect();
    assert_eq!(now, RECORDED, "a published scene changed; now {now:#x?}");
}

/// Families with seeds 0 and 2^64 - 1. They were recorded once; a change here is a change of
/// everybody's scenes.
const RECORDED: [(&str, u64, u64); 9] = [
    ("corridor", 0xda7a_3761_f0c4_5724, 0xdae2_3381_bb54_f991),
    ("room", 0x77c2_3c72_20a7_6a01, 0xe120_7c3e_7485_73a8),
    ("kissing", 0xfff2_61eb_9c65_30c5, 0x05a5_c882_e1b3_e5e8),
    ("ring", 0xa158_5bf3_300a_7347, 0x95e8_a69a_4939_b737),
    ("chain", 0xcf41_2a1c_4e94_ccf1, 0xd286_162d_b63b_94cc),
    ("random", 0x7c09_48a0_b53a_97b4, 0xefc3_d472_3e46_22f3),
    ("anywhere", 0x2df1_dfff_e27d_7c39, 0x6b69_7fcd_2d02_d62a),
    ("lattice", 0x0f07_c3f3_1c74_24c0, 0x8c42_3d7e_abc2_a2a8),
    ("sphereflake", 0x019a_f8ae_a16e_1026, 0x0ddd_ad7d_70b5_db1d),
];

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
