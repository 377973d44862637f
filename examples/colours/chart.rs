//! The classes over hue, saturation and value.
pub(super) fn draw() -> Result<String, Box<dyn std::error::Error>> {
    Ok(String::new())
}
