// The part of three.js that the viewer uses; `renew` bundles it into three.js.
export {
  BufferAttribute, BufferGeometry, Color, DoubleSide, DynamicDrawUsage, LineBasicMaterial, LineSegments, Mesh, PerspectiveCamera, Scene, ShaderMaterial, Vector3, WebGLRenderer,
} from 'three';
export { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
