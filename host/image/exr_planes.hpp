// The planes of a FrameBuffer as OpenEXR sees them.
#pragma once

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>

#include <optional>
#include <vector>

#include "host/image/channel_planes.hpp"
#include "morphcl/frame.hpp"

namespace morphcl {

// The channels of a file that holds these planes.
Imf::ChannelList channel_list(const std::vector<NamedPlane>& planes);

// What a file's channels are of a frame, in the file's order: those that are planes under one of ChannelNames, for each
// channel of the frame the first under which there is any.
std::vector<NamedPlane> planes_in(const Imf::ChannelList& channels);
ChannelSet channels_of(const std::vector<NamedPlane>& planes);

// Slices on the planes of `frame`, whose pixel (0, 0) is (first_x, first_y) of the file's data window: by the names of
// `planes`, and by plain ones where a channel's plane is not among them. Such a one, which the file lacks, is read as
// 0, A as 1.
Imf::FrameBuffer slices_to_read(FrameBuffer& frame, const std::vector<NamedPlane>& planes, int first_x, int first_y);

// The same of the whole frame for a writer, which only reads them.
Imf::FrameBuffer slices_to_write(const FrameBuffer& frame, const std::vector<NamedPlane>& planes);

}  // namespace morphcl
