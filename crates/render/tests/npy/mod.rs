//! The part of NumPy's .npy format that the reference image uses: version 1, little-endian f32,
//! rows first.

/// The shape and the values of an array; panics, as a test should, on anything else.
pub fn read_f32(bytes: &[u8]) -> (Vec<usize>, Vec<f32>) {
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00", "a version 1 .npy file");
    let end = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    let header = std::str::from_utf8(&bytes[10..end]).expect("a header in ASCII");
    assert!(
        header.contains("'<f4'") && header.contains("'fortran_order': False"),
        "{header}"
    );
    let shape = header.split_once('(').expect("a shape").1;
    let shape = shape.split_once(')').expect("its end").0;
    let shape: Vec<usize> = shape
        .split(',')
        .map(|n| n.trim().parse().expect("a length"))
        .collect();
    let values = bytes[end..].chunks_exact(4);
    let values: Vec<f32> = values
        .map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]]))
        .collect();
    assert_eq!(shape.iter().product::<usize>(), values.len());
    (shape, values)
}
