//! A result as NumPy's `.npz`: a ZIP of arrays in NumPy's format 1.0, not compressed.

use std::io::{Cursor, Write};

use anyhow::Result;
use crossfibre::result::RunResult;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use super::{element_places, fibres, node_places};

/// Writes it: `time`, `time_step`, `steps`, and of each fibre `primary_position` and so on, the first
/// index that of the node or element.
pub fn write(result: &RunResult, to: &mut impl Write) -> Result<()> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let mut add = |name: &str, shape: &[usize], numbers: &[f64]| -> Result<()> {
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
        zip.start_file(format!("{name}.npy"), options)?;
        zip.write_all(&array(shape, numbers))?;
        Ok(())
    };
    add("time", &[], &[result.time])?;
    add("time_step", &[], &[result.time_step])?;
    add("steps", &[], &[result.steps as f64])?;
    for (fibre, numbers) in fibres(result) {
        let name = |what: &str| format!("{fibre}_{what}");
        let (nodes, elements) = (node_places(numbers), element_places(numbers));
        for (what, each) in [
            ("node_place", &nodes),
            ("element_place", &elements),
            ("strain", &numbers.strain),
            ("tension", &numbers.tension),
        ] {
            add(&name(what), &[each.len()], each)?;
        }
        for (what, each) in [("position", &numbers.position), ("velocity", &numbers.velocity)] {
            let components = each.first().map_or(0, Vec::len);
            add(&name(what), &[each.len(), components], &each.concat())?;
        }
    }
    to.write_all(zip.finish()?.get_ref())?;
    Ok(())
}

/// An array of doubles in NumPy's format: a header of a multiple of 64 bytes, then the numbers.
fn array(shape: &[usize], numbers: &[f64]) -> Vec<u8> {
    const MAGIC: &[u8] = b"\x93NUMPY\x01\x00";
    let shape: String = shape.iter().map(|length| format!("{length},")).collect();
    let mut header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({shape}), }}");
    // The length of the header itself takes two bytes, and a line ends it.
    let length = (MAGIC.len() + 2 + header.len() + 1).next_multiple_of(64) - MAGIC.len() - 2;
    header += &" ".repeat(length - 1 - header.len());
    header.push('\n');
    let mut bytes = MAGIC.to_vec();
    bytes.extend((length as u16).to_le_bytes());
    bytes.extend(header.into_bytes());
    bytes.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ten bytes, 57 of words and the end of the line are 68: the numbers begin at the next multiple of 64.
    #[test]
    fn numbers_begin_at_the_next_multiple_of_64_bytes() {
        let bytes = array(&[3], &[1.0, 2.0, 3.0]);
        assert_eq!(bytes.len(), 128 + 24);
        assert_eq!((&bytes[8..10], bytes[127]), (&[118, 0][..], b'\n'));
        assert_eq!(bytes[128..136], 1.0_f64.to_le_bytes());
    }
}
