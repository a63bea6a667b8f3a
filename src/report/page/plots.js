// Draws the plots of a page of results anew, so that they can be asked, zoomed and taken apart. Each figure holds an SVG
// that stands where no script runs and that is printed; the drawing takes its place on the screen once it comes into view.
(() => {
  "use strict";
  const root = document.documentElement;
  addEventListener("error", (event) => { root.dataset.fault = event.message; });

  const plots = JSON.parse(document.getElementById("plots").textContent);
  const colour = (name) => getComputedStyle(root).getPropertyValue(name).trim();
  // What a logarithmic axis cannot show is a gap.
  const scaled = (values, axis) => values.map((value) => value === null || (axis.log && !(value > 0)) ? null : value / axis.factor);

  const traces = (plot) => {
    const { x, y } = plot;
    if (plot.cells) {
      return [{
        type: "heatmap", x: scaled(plot.cells.x, x), y: scaled(plot.cells.y, y), z: plot.cells.value,
        colorscale: plot.cells.ramp.map((c, i, all) => [i / (all.length - 1), c]),
        colorbar: { title: { text: plot.cells.title, side: "right" }, thickness: 12 },
        hovertemplate: `%{x:.4g}, %{y:.4g}: %{z:.4g}<extra></extra>`,
      }];
    }
    return plot.lines.flatMap((line) => {
      const paint = line.colour || colour("--ink");
      const trace = {
        type: "scatter", name: line.name, showlegend: line.name !== "", x: scaled(line.x, x), y: scaled(line.y, y),
        mode: [line.line && "lines", line.markers && "markers"].filter(Boolean).join("+"),
        line: { color: paint, width: line.width, dash: line.dashed ? "5px,4px" : "solid" },
        marker: { color: paint, size: 6 },
        hovertemplate: `%{x:.5g}, %{y:.5g}<extra>${line.label.replace(/[<>&]/g, "")}</extra>`,
      };
      if (line.low) {
        const low = { ...trace, y: scaled(line.low, y), showlegend: false };
        return [low, { ...trace, fill: "tonexty", fillcolor: paint + "4d" }];
      }
      if (line.filled) return [{ ...trace, fill: "tozeroy", fillcolor: paint.startsWith("#") ? paint + "29" : paint }];
      return [trace];
    });
  };

  const axis = (a) => ({
    title: { text: a.title, standoff: 6 }, type: a.log ? "log" : "linear", rangemode: a.from_zero ? "tozero" : "normal",
    gridcolor: colour("--line"), zerolinecolor: colour("--line"), linecolor: colour("--muted"), showline: true,
    ticks: "outside", tickcolor: colour("--muted"), automargin: true, exponentformat: "power",
  });

  // The legend stands below the axis, in as many rows as its names ask for.
  const legendHeight = (plot) => {
    const names = plot.lines.map((line) => line.name).filter(Boolean);
    const inRow = Math.max(1, Math.floor(430 / (46 + 6.2 * Math.max(0, ...names.map((name) => name.length)))));
    return names.length > 0 ? 10 + 19 * Math.ceil(names.length / inRow) : 0;
  };

  const layout = (plot) => ({
    height: 330 + legendHeight(plot), margin: { l: 20, r: 16, t: 12, b: 46 + legendHeight(plot) }, paper_bgcolor: "transparent", plot_bgcolor: "transparent",
    font: { family: "inherit", size: 12.5, color: colour("--muted") }, hovermode: "closest",
    hoverlabel: { bgcolor: colour("--card"), font: { color: colour("--ink") }, bordercolor: colour("--line") },
    modebar: { bgcolor: "transparent", color: colour("--line"), activecolor: colour("--accent") },
    legend: { orientation: "h", yref: "container", y: 0, yanchor: "bottom", x: 0, font: { size: 11.5 } }, xaxis: axis(plot.x), yaxis: axis(plot.y),
  });

  // The lines of a figure that moves are its moments, one after the other.
  const animated = (plot, all) => {
    const spread = plot.lines.flatMap((line) => line.y).map((value) => value / plot.y.factor);
    const [low, high] = [Math.min(...spread), Math.max(...spread)];
    const room = 0.06 * (high - low || 1);
    const frames = all.map((trace, i) => ({ name: `${i}`, data: [{ ...trace, showlegend: false }] }));
    const show = (names) => ({
      args: [names, { mode: "immediate", frame: { duration: 60, redraw: false }, transition: { duration: 0 } }],
      method: "animate",
    });
    const settings = layout(plot);
    settings.height = 400;
    settings.yaxis.range = [low - room, high + room];
    settings.updatemenus = [{
      type: "buttons", direction: "left", showactive: false, x: 0, y: 1.02, yanchor: "bottom", xanchor: "left",
      buttons: [{ label: "play", ...show(null) }, { label: "stop", ...show([null]) }],
    }];
    settings.sliders = [{
      pad: { t: 44 }, currentvalue: { visible: false }, ticklen: 3,
      steps: all.map((trace, i) => ({ label: trace.name, ...show([`${i}`]) })),
    }];
    return { data: frames[0].data, layout: settings, frames };
  };

  const draw = (figure) => {
    const plot = plots[figure.dataset.plot];
    const place = document.createElement("div");
    place.className = "live";
    figure.querySelector("svg").after(place);
    const all = traces(plot);
    const moving = plot.moves && all.length > 1 ? animated(plot, all) : null;
    Plotly.newPlot(place, moving ? moving.data : all, moving ? moving.layout : layout(plot), {
      responsive: true, displaylogo: false, modeBarButtonsToRemove: ["lasso2d", "select2d", "autoScale2d"],
      toImageButtonOptions: { format: "svg", filename: plot.name },
    }).then(() => moving && Plotly.addFrames(place, moving.frames));
    figure.classList.add("drawn");
  };

  const figures = [...document.querySelectorAll("figure[data-plot]")];
  if (location.hash === "#all") {
    figures.forEach(draw);
    return;
  }
  const seen = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      if (!entry.isIntersecting) continue;
      seen.unobserve(entry.target);
      draw(entry.target);
    }
  }, { rootMargin: "50px" });
  figures.forEach((figure) => seen.observe(figure));
  // Another colour scheme is another page.
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    for (const figure of figures.filter((f) => f.classList.contains("drawn"))) {
      Plotly.purge(figure.querySelector(".live"));
      figure.querySelector(".live").remove();
      draw(figure);
    }
  });
})();
