//! Results read by the readers that people have: numpy, shapely, geopandas and ezdxf, where they
//! are installed; and points that numpy, shapely, pyarrow, pyshp, geopandas and laspy wrote.
//!
//! `PYTHON` names an interpreter that has them; without it, it is `python3`.

use crate::harness::{Folder, json};
use serde_json::Value;
use std::process::Command;

/// Runs a program after it has imported a module; `None`, and a line that says so, without the
/// module.
fn python(folder: &Folder, module: &str, program: &str) -> Option<String> {
    let interpreter = std::env::var_os("PYTHON").unwrap_or_else(|| "python3".into());
    let run = |program: &str| {
        let mut command = Command::new(&interpreter);
        command
            .current_dir(folder.path())
            .args(["-c", program])
            .output()
    };
    if !run(&format!("import {module}")).is_ok_and(|found| found.status.success()) {
        let name = interpreter.to_string_lossy();
        eprintln!("skipped: there is no {name} with {module}");
        return None;
    }
    let output = run(program).unwrap();
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{stderr}");
    Some(String::from_utf8(output.stdout).unwrap())
}

/// Two rings, one in the other, an open chain and a point alone.
fn varied() -> Folder {
    let square = |r: i32, step: usize| -> String {
        let side = (-r..r).step_by(step);
        side.map(|i| format!("{i} {}\n{r} {i}\n{} {r}\n{} {}\n", -r, -i, -r, -i))
            .collect()
    };
    let points = square(10, 4) + &square(3, 3) + "0.1 40.5\n1 40.5\n2 40.5\n90 90\n";
    Folder::with("p.xy", points)
}

#[test]
fn numpy_reads_edges_and_its_points_are_read() {
    let folder = varied();
    let object = json(&folder.run("reconstruct p.xy --json -o edges.npy").fine());
    let program = "import json, numpy as np\n\
                   a = np.load('edges.npy')\n\
                   assert a.dtype == np.uint32, a.dtype\n\
                   p = np.loadtxt('p.xy')\n\
                   np.save('p.npy', p)\n\
                   np.save('columns.npy', np.asfortranarray(p))\n\
                   np.save('single.npy', p.astype('>f4'))\n\
                   np.save('whole.npy', p.astype(int))\n\
                   print(json.dumps(a.tolist()))";
    let Some(printed) = python(&folder, "numpy", program) else {
        return;
    };
    assert_eq!(json(&printed), object["edges"]);
    for name in ["p.npy", "columns.npy"] {
        let read = json(&folder.run(&format!("reconstruct {name} --json")).fine());
        assert_eq!(read["points"], object["points"], "{name}");
    }
    folder.run("reconstruct single.npy").fine();
    assert!(
        folder
            .run("reconstruct whole.npy")
            .error()
            .contains("`<i8`")
    );
}

#[test]
fn shapely_finds_geojson_wkt_and_wkb_valid() {
    let folder = varied();
    folder.run("reconstruct p.xy -o out.geojson").fine();
    folder.run("reconstruct p.xy -o out.wkt").fine();
    folder.run("reconstruct p.xy -o out.wkb").fine();
    let program = "import json, shapely\n\
                   from shapely.geometry import shape\n\
                   features = json.load(open('out.geojson'))['features']\n\
                   parts = [shape(f['geometry']) for f in features]\n\
                   whole = shapely.from_wkt(open('out.wkt').read())\n\
                   assert whole.is_valid\n\
                   assert whole == shapely.from_wkb(open('out.wkb', 'rb').read())\n\
                   assert list(whole.geoms) == parts, (whole, parts)\n\
                   assert parts[0].exterior.is_ccw and not parts[0].interiors[0].is_ccw\n\
                   print([p.geom_type for p in parts], parts[0].area, parts[1].length)";
    if let Some(printed) = python(&folder, "shapely", program) {
        assert_eq!(
            printed,
            "['Polygon', 'LineString', 'MultiPoint'] 364.0 1.9\n"
        );
    }
}

#[test]
fn geopandas_finds_the_same_in_flatgeobuf_and_geoparquet() {
    let folder = varied();
    for name in ["out.geojson", "out.fgb", "out.parquet"] {
        folder.run(&format!("reconstruct p.xy -o {name}")).fine();
    }
    folder.write("z.csv", "x,y,z\n0,0,1\n2,0,2\n2,2,3\n0,2,4.5\n");
    folder.run("reconstruct z.csv --keep z -o z.fgb").fine();
    folder.run("reconstruct z.csv --keep z -o z.parquet").fine();
    let program = "import geopandas as gpd\n\
                   text = gpd.read_file('out.geojson')\n\
                   flat, rows = gpd.read_file('out.fgb'), gpd.read_parquet('out.parquet')\n\
                   for found in [flat, rows]:\n    \
                   assert list(found.geometry) == list(text.geometry), found\n    \
                   assert found.crs is None and found.is_valid.all()\n    \
                   assert list(found.kind) == ['ring', 'open', 'isolated']\n    \
                   assert list(found.nesting.isna()) == [False, True, True]\n\
                   z = gpd.read_file('z.fgb').geometry[0], gpd.read_parquet('z.parquet').geometry[0]\n\
                   assert z[0] == z[1] and z[0].has_z\n\
                   print(list(z[0].exterior.coords))";
    if let Some(printed) = python(&folder, "geopandas", program) {
        let expected = "[(0.0, 0.0, 1.0), (2.0, 0.0, 2.0), (2.0, 2.0, 3.0), (0.0, 2.0, 4.5), \
                        (0.0, 0.0, 1.0)]\n";
        assert_eq!(printed, expected);
    }
}

#[test]
fn ezdxf_finds_every_polyline_and_nothing_to_mend() {
    let folder = varied();
    folder.run("reconstruct p.xy -o out.dxf").fine();
    let program = "import ezdxf\n\
                   from ezdxf import recover\n\
                   doc, audit = recover.readfile('out.dxf')\n\
                   assert not audit.has_errors, audit.errors\n\
                   found = doc.modelspace().query('POLYLINE')\n\
                   print([(p.dxf.layer, p.is_closed, len(p)) for p in found], len(doc.modelspace().query('POINT')))";
    if let Some(printed) = python(&folder, "ezdxf", program) {
        let expected = "[('rings', True, 20), ('rings', True, 8), ('chains', False, 3)] 1\n";
        assert_eq!(printed, expected);
    }
}

/// Points, and what writes them to a file by a module of Python.
const WRITERS: &[(&str, &str, &str)] = &[
    (
        "numpy",
        "p.npz",
        "import numpy as np; np.savez_compressed('p.npz', x=x, y=y)",
    ),
    (
        "shapely",
        "p.wkb",
        "import shapely; open('p.wkb', 'wb').write(shapely.to_wkb(shapely.MultiPoint(p)))",
    ),
    (
        "pyarrow",
        "p.parquet",
        "import pyarrow as pa, pyarrow.parquet as pq\n\
         pq.write_table(pa.table({'x': x, 'y': y}), 'p.parquet')",
    ),
    (
        "shapefile",
        "p.shp",
        "import shapefile\n\
         with shapefile.Writer('p.shp', shapefile.MULTIPOINT) as w:\n    \
         w.field('n'); w.multipoint(p); w.record(1)",
    ),
    (
        "geopandas",
        "p.fgb",
        "import geopandas as gpd\n\
         s = gpd.GeoSeries.from_xy(x, y, crs=25832)\n\
         s.to_file('p.fgb', driver='FlatGeobuf', SPATIAL_INDEX='NO')",
    ),
    (
        "geopandas",
        "g.parquet",
        "import geopandas as gpd\n\
         gpd.GeoDataFrame(geometry=gpd.GeoSeries.from_xy(x, y)).to_parquet('g.parquet')",
    ),
    (
        "laspy",
        "p.las",
        "import laspy\n\
         h = laspy.LasHeader(point_format=6, version='1.4'); h.scales = [0.5] * 3\n\
         l = laspy.LasData(h); l.x, l.y, l.z = x, y, x; l.write('p.las')",
    ),
];

/// The same with heights, which are 1, 2 and 3.
const WRITERS_OF_HEIGHTS: &[(&str, &str, &str)] = &[
    (
        "numpy",
        "z.npz",
        "import numpy as np; np.savez('z.npz', x=x, y=y, height=[1., 2, 3])",
    ),
    (
        "numpy",
        "z.npy",
        "import numpy as np; np.save('z.npy', np.c_[x, y, [1, 2, 3]])",
    ),
    (
        "pyarrow",
        "z.parquet",
        "import pyarrow as pa, pyarrow.parquet as pq\n\
         pq.write_table(pa.table({'ele': [1, 2, 3], 'x': x, 'y': y}), 'z.parquet')",
    ),
    (
        "shapefile",
        "z.shp",
        "import shapefile\n\
         with shapefile.Writer('z.shp', shapefile.MULTIPOINTZ) as w:\n    \
         w.field('n'); w.multipointz([(*a, i + 1) for i, a in enumerate(p)]); w.record(1)",
    ),
    (
        "shapefile",
        "line.shp",
        "import shapefile\n\
         with shapefile.Writer('line.shp', shapefile.POLYLINEZ) as w:\n    \
         w.field('n'); w.linez([[(*a, i + 1) for i, a in enumerate(p)]]); w.record(1)",
    ),
    (
        "laspy",
        "z.las",
        "import laspy\n\
         h = laspy.LasHeader(point_format=6, version='1.4'); h.scales = [0.5] * 3\n\
         l = laspy.LasData(h); l.x, l.y, l.z = x, y, [1, 2, 3]; l.write('z.las')",
    ),
];

/// What the program prints of each file that a module of Python wrote of three points.
fn written(writers: &[(&str, &str, &str)], options: &str, check: impl Fn(&Value, &str)) {
    let folder = Folder::new();
    let points = "p = [(1.5, -2.0), (3.0, 4.0), (5.0, 4.5)]\nx, y = map(list, zip(*p))\n";
    for (module, name, program) in writers {
        if python(&folder, module, &format!("{points}{program}")).is_none() {
            continue;
        }
        let vertices = if *name == "line.shp" {
            "--vertices"
        } else {
            ""
        };
        let line = format!("reconstruct {name} --json {options} {vertices}");
        check(&json(&folder.run(&line).fine()), name);
    }
}

#[test]
fn heights_of_other_writers_are_read() {
    written(WRITERS_OF_HEIGHTS, "--keep z", |found, name| {
        assert_eq!(found["z"], serde_json::json!([1.0, 2.0, 3.0]), "{name}");
    });
}

#[test]
fn points_of_other_writers_are_read() {
    written(WRITERS, "", |found, name| {
        let expected = serde_json::json!([[1.5, -2.0], [3.0, 4.0], [5.0, 4.5]]);
        assert_eq!(found["points"], expected, "{name}");
    });
}
