//! Arrays of fixed length in files. A position of four numbers is a mistake, perhaps a decimal comma, but the TOML
//! reader silently drops surplus elements and the JSON reader reports "trailing characters". [`FixedLength`] wraps any
//! deserializer and counts.

use std::any::type_name;
use std::fmt;

use serde::de::value::SeqAccessDeserializer;
use serde::de::{
    Deserialize, DeserializeSeed, Deserializer, EnumAccess, Error, IgnoredAny, MapAccess, SeqAccess, VariantAccess,
    Visitor,
};

/// A deserializer, or any of serde's helpers within it, that rejects arrays of the wrong length.
pub struct FixedLength<T>(pub T);

/// Reads an array of fixed length within a visitor.
pub fn from_seq<'de, T: Deserialize<'de>, A: SeqAccess<'de>>(seq: A) -> Result<T, A::Error> {
    T::deserialize(FixedLength(SeqAccessDeserializer::new(seq)))
}

macro_rules! wrap_visitor {
    ($($method:ident($($argument:ident: $type:ty),*))*) => {
        $(fn $method<V: Visitor<'de>>(self, $($argument: $type,)* visitor: V) -> Result<V::Value, D::Error> {
            self.0.$method($($argument,)* FixedLength(visitor))
        })*
    };
}

impl<'de, D: Deserializer<'de>> Deserializer<'de> for FixedLength<D> {
    type Error = D::Error;

    fn deserialize_tuple<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, D::Error> {
        self.0.deserialize_seq(Row { length, visitor })
    }

    wrap_visitor! {
        deserialize_any() deserialize_bool() deserialize_char() deserialize_str() deserialize_string()
        deserialize_i8() deserialize_i16() deserialize_i32() deserialize_i64() deserialize_i128()
        deserialize_u8() deserialize_u16() deserialize_u32() deserialize_u64() deserialize_u128()
        deserialize_f32() deserialize_f64() deserialize_bytes() deserialize_byte_buf()
        deserialize_option() deserialize_unit() deserialize_seq() deserialize_map()
        deserialize_identifier() deserialize_ignored_any()
        deserialize_unit_struct(name: &'static str)
        deserialize_newtype_struct(name: &'static str)
        deserialize_tuple_struct(name: &'static str, length: usize)
        deserialize_struct(name: &'static str, fields: &'static [&'static str])
        deserialize_enum(name: &'static str, variants: &'static [&'static str])
    }

    fn is_human_readable(&self) -> bool {
        self.0.is_human_readable()
    }
}

macro_rules! hand_on {
    ($($method:ident($type:ty))*) => {
        $(fn $method<E: Error>(self, value: $type) -> Result<V::Value, E> {
            self.0.$method(value)
        })*
    };
}

impl<'de, V: Visitor<'de>> Visitor<'de> for FixedLength<V> {
    type Value = V::Value;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.0.expecting(f)
    }

    hand_on! {
        visit_bool(bool) visit_char(char) visit_str(&str) visit_borrowed_str(&'de str) visit_string(String)
        visit_i8(i8) visit_i16(i16) visit_i32(i32) visit_i64(i64) visit_i128(i128)
        visit_u8(u8) visit_u16(u16) visit_u32(u32) visit_u64(u64) visit_u128(u128)
        visit_f32(f32) visit_f64(f64) visit_bytes(&[u8]) visit_borrowed_bytes(&'de [u8]) visit_byte_buf(Vec<u8>)
    }

    fn visit_none<E: Error>(self) -> Result<V::Value, E> {
        self.0.visit_none()
    }

    fn visit_unit<E: Error>(self) -> Result<V::Value, E> {
        self.0.visit_unit()
    }

    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<V::Value, D::Error> {
        self.0.visit_some(FixedLength(deserializer))
    }

    fn visit_newtype_struct<D: Deserializer<'de>>(self, deserializer: D) -> Result<V::Value, D::Error> {
        self.0.visit_newtype_struct(FixedLength(deserializer))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<V::Value, A::Error> {
        self.0.visit_seq(FixedLength(seq))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<V::Value, A::Error> {
        self.0.visit_map(FixedLength(map))
    }

    fn visit_enum<A: EnumAccess<'de>>(self, data: A) -> Result<V::Value, A::Error> {
        self.0.visit_enum(FixedLength(data))
    }
}

impl<'de, S: DeserializeSeed<'de>> DeserializeSeed<'de> for FixedLength<S> {
    type Value = S::Value;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<S::Value, D::Error> {
        self.0.deserialize(FixedLength(deserializer))
    }
}

impl<'de, A: SeqAccess<'de>> SeqAccess<'de> for FixedLength<A> {
    type Error = A::Error;

    fn next_element_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<Option<S::Value>, A::Error> {
        self.0.next_element_seed(FixedLength(seed))
    }

    fn size_hint(&self) -> Option<usize> {
        self.0.size_hint()
    }
}

impl<'de, A: MapAccess<'de>> MapAccess<'de> for FixedLength<A> {
    type Error = A::Error;

    fn next_key_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<Option<S::Value>, A::Error> {
        self.0.next_key_seed(FixedLength(seed))
    }

    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, A::Error> {
        self.0.next_value_seed(FixedLength(seed))
    }

    fn size_hint(&self) -> Option<usize> {
        self.0.size_hint()
    }
}

impl<'de, A: EnumAccess<'de>> EnumAccess<'de> for FixedLength<A> {
    type Error = A::Error;
    type Variant = FixedLength<A::Variant>;

    fn variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<(S::Value, Self::Variant), A::Error> {
        let (value, variant) = self.0.variant_seed(FixedLength(seed))?;
        Ok((value, FixedLength(variant)))
    }
}

impl<'de, A: VariantAccess<'de>> VariantAccess<'de> for FixedLength<A> {
    type Error = A::Error;

    fn unit_variant(self) -> Result<(), A::Error> {
        self.0.unit_variant()
    }

    fn newtype_variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<S::Value, A::Error> {
        self.0.newtype_variant_seed(FixedLength(seed))
    }

    fn tuple_variant<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, A::Error> {
        self.0.tuple_variant(length, FixedLength(visitor))
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, A::Error> {
        self.0.struct_variant(fields, FixedLength(visitor))
    }
}

/// Reads one array and counts its elements.
struct Row<V> {
    length: usize,
    visitor: V,
}

impl<V> Row<V> {
    /// The noun for the elements in messages: arrays in the formats contain numbers or names.
    fn noun<T>(count: usize) -> &'static str {
        match (type_name::<T>().contains("String"), count) {
            (true, 1) => "name",
            (true, _) => "names",
            (false, 1) => "number",
            (false, _) => "numbers",
        }
    }
}

impl<'de, V: Visitor<'de>> Visitor<'de> for Row<V> {
    type Value = V::Value;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "an array of {} {}", self.length, Self::noun::<V::Value>(self.length))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<V::Value, A::Error> {
        let mut seq = Counted { seq, count: 0, ended: false };
        let row = self.visitor.visit_seq(&mut seq);
        if row.is_err() && !seq.ended {
            return row; // an element that is itself wrong
        }
        while seq.next_element::<IgnoredAny>()?.is_some() {}
        if seq.count == self.length {
            return row;
        }
        let noun = Self::noun::<V::Value>(seq.count);
        Err(A::Error::custom(format!("found {} {noun}, expected {}{}", seq.count, self.length, parts(self.length))))
    }
}

/// The meaning of the numbers, if it follows from their count: all arrays of six are wrenches, all of four are
/// quaternions.
fn parts(length: usize) -> &'static str {
    match length {
        6 => ": fx fy fz mx my mz",
        4 => ": w x y z",
        _ => "",
    }
}

struct Counted<A> {
    seq: A,
    count: usize,
    ended: bool,
}

impl<'de, A: SeqAccess<'de>> SeqAccess<'de> for Counted<A> {
    type Error = A::Error;

    fn next_element_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<Option<S::Value>, A::Error> {
        if self.ended {
            return Ok(None);
        }
        let element = self.seq.next_element_seed(FixedLength(seed))?;
        self.count += usize::from(element.is_some());
        self.ended = element.is_none();
        Ok(element)
    }
}
