//! A picture as PNG.

use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};

use crate::picture::Picture;

/// The file's bytes, 8-bit RGB. Equal pictures are equal files.
///
/// # Panics
/// If the picture's pixels are not as many as it says.
#[must_use]
pub(crate) fn file(picture: &Picture) -> Vec<u8> {
    let Picture { pixels, width, height, .. } = picture;
    assert_eq!(pixels.len(), *width as usize * *height as usize, "{}: its size", picture.name);
    let mut bytes = Vec::new();
    PngEncoder::new(&mut bytes)
        .write_image(pixels.as_flattened(), *width, *height, ExtendedColorType::Rgb8)
        .expect("a picture of that size can be written to memory");
    bytes
}
