"""The three-dimensional model in reports and in the browser: content, packing and server."""
