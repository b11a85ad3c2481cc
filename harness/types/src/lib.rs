//! Elementary data types, typed values, IEC literals, dialect names and diagnostic codes.
