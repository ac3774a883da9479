"""The model in three dimensions, in a report and in a browser: what is shown, how it is packed, and the server."""
