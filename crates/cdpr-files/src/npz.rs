//! Arrays in an .npz file, as NumPy writes them.

use std::io::{self, Cursor, Write};

use npyz::{DType, WriteOptions, WriterBuilder};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// An .npz file in memory; stored uncompressed, as by `numpy.savez`.
pub(super) struct Npz(ZipWriter<Cursor<Vec<u8>>>);

impl Npz {
    /// A file without arrays.
    pub(super) fn new() -> Self {
        Npz(ZipWriter::new(Cursor::new(Vec::new())))
    }

    fn begin(&mut self, name: &str) -> io::Result<()> {
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
        self.0.start_file(npyz::npz::file_name_from_array_name(name), options).map_err(io::Error::other)
    }

    /// Adds an array of float64.
    pub(super) fn numbers(&mut self, name: &str, shape: &[u64], numbers: &[f64]) -> io::Result<()> {
        self.array(name, shape, "<f8", numbers)
    }

    /// Adds an array of int64.
    pub(super) fn integers(&mut self, name: &str, shape: &[u64], integers: &[i64]) -> io::Result<()> {
        self.array(name, shape, "<i8", integers)
    }

    fn array<T: npyz::Serialize>(&mut self, name: &str, shape: &[u64], dtype: &str, numbers: &[T]) -> io::Result<()> {
        self.begin(name)?;
        let mut array = Vec::with_capacity(8 * numbers.len() + 128); // the checksum of a zip file is slow on single numbers
        let dtype = DType::Plain(dtype.parse().map_err(io::Error::other)?);
        let mut writer = WriteOptions::new().dtype(dtype).shape(shape).writer(&mut array).begin_nd()?;
        writer.extend(numbers)?;
        writer.finish()?;
        self.0.write_all(&array)
    }

    /// Adds an array of texts.
    pub(super) fn texts(&mut self, name: &str, shape: &[u64], texts: &[&str]) -> io::Result<()> {
        self.begin(name)?;
        let longest = texts.iter().map(|text| text.chars().count()).max().unwrap_or(0);
        let dtype = DType::Plain(format!("<U{longest}").parse().map_err(io::Error::other)?);
        let mut writer = WriteOptions::new().dtype(dtype).shape(shape).writer(&mut self.0).begin_nd()?;
        for text in texts {
            writer.push(*text)?;
        }
        writer.finish()
    }

    /// The bytes of the file.
    pub(super) fn finish(self) -> io::Result<Vec<u8>> {
        Ok(self.0.finish().map_err(io::Error::other)?.into_inner())
    }
}
