// Unpacks the libraries and the viewer of a report, and starts them one after another.
(async function () {
  try {
    if (typeof DecompressionStream === "undefined") throw new Error("this browser is too old for it");
    for (const packed of document.querySelectorAll("script[data-packed]")) {
      const raw = atob(packed.textContent.trim());
      const bytes = Uint8Array.from(raw, (letter) => letter.charCodeAt(0));
      const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
      const script = document.createElement("script");
      script.textContent = await new Response(stream).text();
      document.head.append(script);
    }
  } catch (error) {
    for (const place of document.querySelectorAll(".hawser-view")) place.textContent = `The model is not shown in three dimensions: ${error.message}.`;
  }
})();
