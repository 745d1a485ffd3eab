#pragma once
#include <hdf5.h>

#include <cstdint>
#include <memory>
#include <string>

// Only the files that speak HDF5 include this one.
namespace arenite::io {

/// An HDF5 identifier that closes itself.
using Hdf5Handle = std::shared_ptr<const std::int64_t>;
static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// Takes over what HDF5 returned; a null handle if the call failed.
Hdf5Handle own(hid_t id, herr_t (*close)(hid_t));

/// The same for what we build in memory: this fails only for lack of memory or by our own fault, std::runtime_error.
Hdf5Handle made(hid_t id, herr_t (*close)(hid_t));
void done(herr_t status);

/// Starts HDF5 in this process, for all processes that are forked from it.
void prepare_hdf5();

/// For a file in memory; silences HDF5's own messages on stderr, since failures become our errors.
Hdf5Handle memory_properties();

/// HDF5 takes two open files of one name for the same file, so each file in memory has a name of its own.
std::string unused_name();

/// How numbers lie in the file (lowest byte first on every machine), and how in memory.
template <class T> hid_t stored_type();
template <> inline hid_t stored_type<double>() { return H5T_IEEE_F64LE; }
template <> inline hid_t stored_type<float>() { return H5T_IEEE_F32LE; }
template <> inline hid_t stored_type<std::int32_t>() { return H5T_STD_I32LE; }
template <> inline hid_t stored_type<std::int64_t>() { return H5T_STD_I64LE; }
template <> inline hid_t stored_type<std::uint64_t>() { return H5T_STD_U64LE; }
template <> inline hid_t stored_type<std::uint8_t>() { return H5T_STD_U8LE; }
template <class T> hid_t native_type();
template <> inline hid_t native_type<double>() { return H5T_NATIVE_DOUBLE; }
template <> inline hid_t native_type<float>() { return H5T_NATIVE_FLOAT; }
template <> inline hid_t native_type<std::int32_t>() { return H5T_NATIVE_INT32; }
template <> inline hid_t native_type<std::int64_t>() { return H5T_NATIVE_INT64; }
template <> inline hid_t native_type<std::uint64_t>() { return H5T_NATIVE_UINT64; }
template <> inline hid_t native_type<std::uint8_t>() { return H5T_NATIVE_UINT8; }

}  // namespace arenite::io
