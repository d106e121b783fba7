// Bundles three.in.mjs and uPlot in the current folder (called by `renew`, which installed the packages there).
// WebGLRenderer holds the text of every shader of three.js, 170 KB that no tree shaking finds. The viewer draws with its own
// ShaderMaterial and with LineBasicMaterial, so the texts that the shader `meshbasic` does not include become empty, but for the one that
// WebGLProgram puts into every shader.
import { createRequire } from 'node:module';
import { readFileSync } from 'node:fs';
import path from 'node:path';

const require = createRequire(path.resolve('package.json'));
const { build } = require('esbuild');
const source = path.resolve('node_modules/three/src');
const shaders = `${source}/renderers/shaders`;
const kept = new Set(['meshbasic', 'colorspace_pars_fragment']);

function keepIncludes(text) {
  for (const [, name] of text.matchAll(/#include <([\w]+)>/g)) {
    if (kept.has(name)) continue;
    kept.add(name);
    keepIncludes(readFileSync(`${shaders}/ShaderChunk/${name}.glsl.js`, 'utf8'));
  }
}
keepIncludes(readFileSync(`${shaders}/ShaderLib/meshbasic.glsl.js`, 'utf8'));

const smaller = {
  name: 'smaller',
  setup(bundler) {
    bundler.onResolve({ filter: /^three$/ }, () => ({ path: `${source}/Three.js`, sideEffects: false }));
    bundler.onLoad({ filter: /\.glsl\.js$/ }, ({ path: file }) => {
      if (kept.has(path.basename(file, '.glsl.js'))) return undefined;
      const library = file.includes('ShaderLib');
      return { contents: library ? "export const vertex = ''; export const fragment = '';" : "export default '';" };
    });
  },
};
const options = { bundle: true, minify: true, format: 'esm', target: 'es2022', legalComments: 'none', logLevel: 'warning' };
await build({ ...options, entryPoints: ['three.in.mjs'], outfile: 'three.js', plugins: [smaller] });
await build({ ...options, entryPoints: ['node_modules/uplot/dist/uPlot.esm.js'], outfile: 'uplot.js' });
