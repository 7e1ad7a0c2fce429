//! Short hashes that identify scenes, maps and experiments.

use hmac_sha256::Hash;

/// The first 16 hexadecimal digits of the SHA-256 of a text.
///
/// # Example
/// ```
/// assert_eq!(cdpr_core::fingerprint::fingerprint_of(""), "e3b0c44298fc1c14");
/// ```
pub fn fingerprint_of(text: &str) -> String {
    Hash::hash(text.as_bytes()).iter().take(8).map(|byte| format!("{byte:02x}")).collect()
}
