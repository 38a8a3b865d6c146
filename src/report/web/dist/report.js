/*
The page of ljmd report contains these packages:

@observablehq/plot 0.6.17 (ISC)

Copyright 2020-2025 Observable, Inc.

Permission to use, copy, modify, and/or distribute this software for any purpose
with or without fee is hereby granted, provided that the above copyright notice
and this permission notice appear in all copies.

THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND
FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM LOSS
OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER
TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF
THIS SOFTWARE.

------------------------------------------------------------------------

binary-search-bounds 2.0.5 (MIT)

The MIT License (MIT)

Copyright (c) 2013-2015 Mikola Lysenko

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

------------------------------------------------------------------------

d3 7.9.2 (ISC), d3-array 3.2.5 (ISC), d3-axis 3.0.1 (ISC), d3-brush 3.0.1 (ISC), d3-chord 3.0.2 (ISC), d3-color 3.1.1 (ISC), d3-dispatch 3.0.2 (ISC), d3-drag 3.0.1 (ISC), d3-force 3.0.1 (ISC), d3-format 3.1.3 (ISC), d3-hierarchy 3.1.3 (ISC), d3-interpolate 3.0.2 (ISC), d3-polygon 3.0.2 (ISC), d3-quadtree 3.0.2 (ISC), d3-random 3.0.2 (ISC), d3-scale 4.0.3 (ISC), d3-selection 3.0.1 (ISC), d3-shape 3.2.1 (ISC), d3-time 3.1.1 (ISC), d3-time-format 4.1.1 (ISC), d3-timer 3.0.2 (ISC), d3-transition 3.0.2 (ISC), d3-zoom 3.0.1 (ISC)

Copyright 2010-2026 Mike Bostock

Permission to use, copy, modify, and/or distribute this software for any purpose
with or without fee is hereby granted, provided that the above copyright notice
and this permission notice appear in all copies.

THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND
FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM LOSS
OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER
TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF
THIS SOFTWARE.

------------------------------------------------------------------------

d3-contour 4.0.3 (ISC)

Copyright 2012-2026 Mike Bostock

Permission to use, copy, modify, and/or distribute this software for any purpose
with or without fee is hereby granted, provided that the above copyright notice
and this permission notice appear in all copies.

THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND
FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM LOSS
OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER
TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF
THIS SOFTWARE.

------------------------------------------------------------------------

d3-delaunay 6.0.6 (ISC)

Copyright 2018-2026 Observable, Inc.
Copyright 2021 Mapbox

Permission to use, copy, modify, and/or distribute this software for any purpose
with or without fee is hereby granted, provided that the above copyright notice
and this permission notice appear in all copies.

THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND
FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM LOSS
OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER
TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF
THIS SOFTWARE.

------------------------------------------------------------------------

d3-dsv 3.0.2 (ISC)

Copyright 2013-2026 Mike Bostock

Permission to use, copy, modify, and/or distribute this software for any purpose
with or without fee is hereby granted, provided that the above copyright notice
and this permission notice appear in all copies.

THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND
FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM LOSS
OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER
TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF
THIS SOFTWARE.

------------------------------------------------------------------------

d3-ease 3.0.2 (BSD-3-Clause)

Copyright 2010-2026 Mike Bostock
Copyright 2001 Robert Penner
All rights reserved.

Redistribution and use in source and binary forms, with or without modification,
are permitted provided that the following conditions are met:

* Redistributions of source code must retain the above copyright notice, this
  list of conditions and the following disclaimer.

* Redistributions in binary form must reproduce the above copyright notice,
  this list of conditions and the following disclaimer in the documentation
  and/or other materials provided with the distribution.

* Neither the name of the author nor the names of contributors may be used to
  endorse or promote products derived from this software without specific prior
  written permission.

THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS "AS IS" AND
ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT LIMITED TO, THE IMPLIED
WARRANTIES OF MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE ARE
DISCLAIMED. IN NO EVENT SHALL THE COPYRIGHT OWNER OR CONTRIBUTORS BE LIABLE FOR
ANY DIRECT, INDIRECT, INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES
(INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER CAUSED AND ON
ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT LIABILITY, OR TORT
(INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN ANY WAY OUT OF THE USE OF THIS
SOFTWARE, EVEN IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE.

------------------------------------------------------------------------

d3-fetch 3.0.2 (ISC)

Copyright 2016-2026 Mike Bostock

Permission to use, copy, modify, and/or distribute this software for any purpose
with or without fee is hereby granted, provided that the above copyright notice
and this permission notice appear in all copies.

THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND
FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM LOSS
OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER
TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF
THIS SOFTWARE.

------------------------------------------------------------------------

d3-geo 3.1.2 (ISC)

Copyright 2010-2026 Mike Bostock

Permission to use, copy, modify, and/or distribute this software for any purpose
with or without fee is hereby granted, provided that the above copyright notice
and this permission notice appear in all copies.

THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND
FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM LOSS
OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER
TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF
THIS SOFTWARE.

This license applies to GeographicLib, versions 1.12 and later.

Copyright 2008-2012 Charles Karney

Permission is hereby granted, free of charge, to any person obtaining a copy of
this software and associated documentation files (the "Software"), to deal in
the Software without restriction, including without limitation the rights to
use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of
the Software, and to permit persons to whom the Software is furnished to do so,
subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS
FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT.  IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER
IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN
CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.

------------------------------------------------------------------------

d3-path 3.1.1 (ISC)

Copyright 2015-2026 Mike Bostock

Permission to use, copy, modify, and/or distribute this software for any purpose
with or without fee is hereby granted, provided that the above copyright notice
and this permission notice appear in all copies.

THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND
FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM LOSS
OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER
TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF
THIS SOFTWARE.

------------------------------------------------------------------------

d3-scale-chromatic 3.1.1 (ISC)

Copyright 2010-2026 Mike Bostock

Permission to use, copy, modify, and/or distribute this software for any purpose
with or without fee is hereby granted, provided that the above copyright notice
and this permission notice appear in all copies.

THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND
FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM LOSS
OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER
TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF
THIS SOFTWARE.

Apache-Style Software License for ColorBrewer software and ColorBrewer Color Schemes

Copyright 2002 Cynthia Brewer, Mark Harrower, and The Pennsylvania State University

Licensed under the Apache License, Version 2.0 (the "License"); you may not use
this file except in compliance with the License. You may obtain a copy of the
License at

http://www.apache.org/licenses/LICENSE-2.0

Unless required by applicable law or agreed to in writing, software distributed
under the License is distributed on an "AS IS" BASIS, WITHOUT WARRANTIES OR
CONDITIONS OF ANY KIND, either express or implied. See the License for the
specific language governing permissions and limitations under the License.

------------------------------------------------------------------------

interval-tree-1d 1.0.4 (MIT)

The MIT License (MIT)

Copyright (c) 2013 Mikola Lysenko

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

------------------------------------------------------------------------

isoformat 0.2.1 (ISC)

Copyright 2021 Mike Bostock

Permission to use, copy, modify, and/or distribute this software for any purpose
with or without fee is hereby granted, provided that the above copyright notice
and this permission notice appear in all copies.

THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND
FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM LOSS
OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER
TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF
THIS SOFTWARE.

------------------------------------------------------------------------

three 0.170.0 (MIT)

The MIT License

Copyright © 2010-2024 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
(()=>{function D(e,t={},...n){let i=document.createElement(e);for(let[r,s]of Object.entries(t))s==null||s===!1||(typeof s=="function"?i.addEventListener(r.replace(/^on/,""),s):i.setAttribute(r,s===!0?"":String(s)));return i.append(...n.flat(1/0).filter(r=>r!=null&&r!==!1).map(r=>r instanceof Node?r:String(r))),i}var s_=new Map;function ho(e){let t=`s-${String(e).toLowerCase().replace(/[^a-z0-9]+/g,"-").replace(/^-|-$/g,"").slice(0,40)||"x"}`,n=(s_.get(t)??0)+1;return s_.set(t,n),n===1?t:`${t}-${n}`}function Fe(e,t,...n){let i=D(`h${t}`,{id:ho(e)},e);return D("section",{"aria-labelledby":i.id},i,...n)}function ds(e,t){return D("div",{class:"scroll",tabindex:0,role:"region","aria-label":e},t)}var TA={epsilon:"ε",sigma:"σ",tau:"τ",rho:"ρ",eta:"η",theta:"θ",phi:"φ",omega:"ω",lambda:"λ",delta:"δ",Delta:"Δ",sqrt:"√",pi:"π",mu:"μ",chi:"χ",gamma:"γ"},o_={0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹","-":"⁻","+":"⁺"},Xa="−";function jt(e){return String(e??"").replace(/[A-Za-z]+/g,t=>TA[t]??t).replace(/(<[^<>]*>)\^\(1\/2\)/g,"√$1").replace(/\^([-+]?\d+)/g,(t,n)=>[...n].map(i=>o_[i]).join("")).replace(/ \+- /g," ± ").replace(/(^|[\s(:,])-(?=[\d.])/g,`$1${Xa}`)}function Xh(e){return[...jt(e).matchAll(/([^_]*?)(?:(?<=[^\s_])_(\w+)|$)/g)].map(t=>[t[1],t[2]??""]).filter(([t,n])=>t!==""||n!=="")}function Yi(e){return Xh(e).flatMap(([t,n])=>{if(n==="")return[document.createTextNode(t)];let i=document.createElement("sub");return i.textContent=n,[document.createTextNode(t),i]})}function ce(e,t=6){if(e==null||Number.isNaN(e))return"–";if(typeof e!="number")return String(e);if(Number.isInteger(e)&&Math.abs(e)<1e9)return AA(String(e));let n=Math.abs(e);return n!==0&&(n>=1e6||n<1e-4)?EA(e,t):e.toPrecision(t).replace(/(\.\d*?)0+$/,"$1").replace(/\.$/,"").replace("-",Xa)}function EA(e,t){let[n,i]=e.toExponential(Math.min(t,4)-1).split("e"),r=n.replace(/(\.\d*?)0+$/,"$1").replace(/\.$/,"").replace("-",Xa);return`${r==="1"?"":`${r}×`}10${[...String(Number(i))].map(o=>o_[o]).join("")}`}function AA(e){let t=e.startsWith("-")?Xa:"",n=e.replace("-","");return t+(n.length<5?n:n.replace(/\B(?=(\d{3})+$)/g," "))}function Ir(e,t){if(e==null)return"–";if(!(t>0)||!Number.isFinite(t))return ce(e);let n=1-Math.floor(Math.log10(t)),i=Math.max(Math.abs(e),t);return n>9||n<0||i>=1e6?`${ce(e)} ± ${ce(t,2)}`:`${e.toFixed(n)} ± ${t.toFixed(n)}`.replace("-",Xa)}function ii(e,t){let n=String(e).replace(/[^A-Za-z0-9._-]+/g,"-").replace(/^[-.]+|-+$/g,"").slice(0,80)||"ljmd";return n.endsWith(t)?n:n+t}function ps(e,t,n="text/plain"){let i=t instanceof Blob?t:new Blob([t],{type:`${n};charset=utf-8`}),r=D("a",{href:URL.createObjectURL(i),download:e});document.body.append(r),r.click(),r.remove(),setTimeout(()=>URL.revokeObjectURL(r.href),1e4)}function po(e,t,n,i){return D("button",{type:"button",class:"small",onclick:()=>ps(t,n(),i)},e)}function a_(e,t){let n=D("button",{type:"button",class:"small"},e);return n.addEventListener("click",async()=>{try{await navigator.clipboard.writeText(t.textContent),n.textContent="Copied"}catch{window.getSelection().selectAllChildren(t),n.textContent="Selected: press Ctrl+C"}setTimeout(()=>n.textContent=e,2e3)}),n}function tn(e,t){return e==null||t==null?NaN:e<t?-1:e>t?1:e>=t?0:NaN}function Zi(e,t){return e==null||t==null?NaN:t<e?-1:t>e?1:t>=e?0:NaN}function _o(e){let t,n,i;e.length!==2?(t=tn,n=(a,c)=>tn(e(a),c),i=(a,c)=>e(a)-c):(t=e===tn||e===Zi?e:CA,n=e,i=e);function r(a,c,l=0,u=a.length){if(l<u){if(t(c,c)!==0)return u;do{let h=l+u>>>1;n(a[h],c)<0?l=h+1:u=h}while(l<u)}return l}function s(a,c,l=0,u=a.length){if(l<u){if(t(c,c)!==0)return u;do{let h=l+u>>>1;n(a[h],c)<=0?l=h+1:u=h}while(l<u)}return l}function o(a,c,l=0,u=a.length){let h=r(a,c,l,u-1);return h>l&&i(a[h-1],c)>-i(a[h],c)?h-1:h}return{left:r,center:o,right:s}}function CA(){return 0}function c_(e){return e===null?NaN:+e}function*RA(e,t){if(t===void 0)for(let n of e)n!=null&&(n=+n)>=n&&(yield n);else{let n=-1;for(let i of e)(i=t(i,++n,e))!=null&&(i=+i)>=i&&(yield i)}}var l_=_o(tn),vo=l_.right,ck=l_.left,lk=_o(c_).center;var uk=u_(f_),fk=u_(IA);function u_(e){return function(t,n,i=n){if(!((n=+n)>=0))throw new RangeError("invalid rx");if(!((i=+i)>=0))throw new RangeError("invalid ry");let{data:r,width:s,height:o}=t;if(!((s=Math.floor(s))>=0))throw new RangeError("invalid width");if(!((o=Math.floor(o!==void 0?o:r.length/s))>=0))throw new RangeError("invalid height");if(!s||!o||!n&&!i)return t;let a=n&&e(n),c=i&&e(i),l=r.slice();return a&&c?(mo(a,l,r,s,o),mo(a,r,l,s,o),mo(a,l,r,s,o),go(c,r,l,s,o),go(c,l,r,s,o),go(c,r,l,s,o)):a?(mo(a,r,l,s,o),mo(a,l,r,s,o),mo(a,r,l,s,o)):c&&(go(c,r,l,s,o),go(c,l,r,s,o),go(c,r,l,s,o)),t}}function mo(e,t,n,i,r){for(let s=0,o=i*r;s<o;)e(t,n,s,s+=i,1)}function go(e,t,n,i,r){for(let s=0,o=i*r;s<i;++s)e(t,n,s,s+o,i)}function IA(e){let t=f_(e);return(n,i,r,s,o)=>{r<<=2,s<<=2,o<<=2,t(n,i,r+0,s+0,o),t(n,i,r+1,s+1,o),t(n,i,r+2,s+2,o),t(n,i,r+3,s+3,o)}}function f_(e){let t=Math.floor(e);if(t===e)return PA(e);let n=e-t,i=2*e+1;return(r,s,o,a,c)=>{if(!((a-=c)>=o))return;let l=t*s[o],u=c*t,h=u+c;for(let f=o,d=o+u;f<d;f+=c)l+=s[Math.min(a,f)];for(let f=o,d=a;f<=d;f+=c)l+=s[Math.min(a,f+u)],r[f]=(l+n*(s[Math.max(o,f-h)]+s[Math.min(a,f+h)]))/i,l-=s[Math.max(o,f-u)]}}function PA(e){let t=2*e+1;return(n,i,r,s,o)=>{if(!((s-=o)>=r))return;let a=e*i[r],c=o*e;for(let l=r,u=r+c;l<u;l+=o)a+=i[Math.min(s,l)];for(let l=r,u=s;l<=u;l+=o)a+=i[Math.min(s,l+c)],n[l]=a/t,a-=i[Math.max(r,l-c)]}}function Zh(e,t){let n=0;if(t===void 0)for(let i of e)i!=null&&(i=+i)>=i&&++n;else{let i=-1;for(let r of e)(r=t(r,++i,e))!=null&&(r=+r)>=r&&++n}return n}function LA(e){return e.length|0}function NA(e){return!(e>0)}function DA(e){return typeof e!="object"||"length"in e?e:Array.from(e)}function UA(e){return t=>e(...t)}function h_(...e){let t=typeof e[e.length-1]=="function"&&UA(e.pop());e=e.map(DA);let n=e.map(LA),i=e.length-1,r=new Array(i+1).fill(0),s=[];if(i<0||n.some(NA))return s;for(;;){s.push(r.map((a,c)=>e[c][a]));let o=i;for(;++r[o]===n[o];){if(o===0)return t?s.map(t):s;r[o--]=0}}}function d_(e,t){var n=0,i=0;return Float64Array.from(e,t===void 0?r=>n+=+r||0:r=>n+=+t(r,i++,e)||0)}function Jh(e,t){let n=0,i,r=0,s=0;if(t===void 0)for(let o of e)o!=null&&(o=+o)>=o&&(i=o-r,r+=i/++n,s+=i*(o-r));else{let o=-1;for(let a of e)(a=t(a,++o,e))!=null&&(a=+a)>=a&&(i=a-r,r+=i/++n,s+=i*(a-r))}if(n>1)return s/(n-1)}function Kh(e,t){let n=Jh(e,t);return n&&Math.sqrt(n)}function Je(e,t){let n,i;if(t===void 0)for(let r of e)r!=null&&(n===void 0?r>=r&&(n=i=r):(n>r&&(n=r),i<r&&(i=r)));else{let r=-1;for(let s of e)(s=t(s,++r,e))!=null&&(n===void 0?s>=s&&(n=i=s):(n>s&&(n=s),i<s&&(i=s)))}return[n,i]}var Fn=class{constructor(){this._partials=new Float64Array(32),this._n=0}add(t){let n=this._partials,i=0;for(let r=0;r<this._n&&r<32;r++){let s=n[r],o=t+s,a=Math.abs(t)<Math.abs(s)?t-(o-s):s-(o-t);a&&(n[i++]=a),t=o}return n[i]=t,this._n=i+1,this}valueOf(){let t=this._partials,n=this._n,i,r,s,o=0;if(n>0){for(o=t[--n];n>0&&(i=o,r=t[--n],o=i+r,s=r-(o-i),!s););n>0&&(s<0&&t[n-1]<0||s>0&&t[n-1]>0)&&(r=s*2,i=o+r,r==i-o&&(o=i))}return o}};var On=class extends Map{constructor(t,n=g_){if(super(),Object.defineProperties(this,{_intern:{value:new Map},_key:{value:n}}),t!=null)for(let[i,r]of t)this.set(i,r)}get(t){return super.get(Yh(this,t))}has(t){return super.has(Yh(this,t))}set(t,n){return super.set(p_(this,t),n)}delete(t){return super.delete(m_(this,t))}},Mi=class extends Set{constructor(t,n=g_){if(super(),Object.defineProperties(this,{_intern:{value:new Map},_key:{value:n}}),t!=null)for(let i of t)this.add(i)}has(t){return super.has(Yh(this,t))}add(t){return super.add(p_(this,t))}delete(t){return super.delete(m_(this,t))}};function Yh({_intern:e,_key:t},n){let i=t(n);return e.has(i)?e.get(i):n}function p_({_intern:e,_key:t},n){let i=t(n);return e.has(i)?e.get(i):(e.set(i,n),n)}function m_({_intern:e,_key:t},n){let i=t(n);return e.has(i)&&(n=e.get(i),e.delete(i)),n}function g_(e){return e!==null&&typeof e=="object"?e.valueOf():e}function qh(e){return e}function ms(e,...t){return jh(e,qh,qh,t)}function Ji(e,t,...n){return jh(e,qh,t,n)}function y_(e,t,...n){return jh(e,Array.from,t,n)}function jh(e,t,n,i){return function r(s,o){if(o>=i.length)return n(s);let a=new On,c=i[o++],l=-1;for(let u of s){let h=c(u,++l,s),f=a.get(h);f?f.push(u):a.set(h,[u])}for(let[u,h]of a)a.set(u,r(h,o));return t(a)}(e,0)}function FA(e,t){return Array.from(t,n=>e[n])}function yo(e,...t){if(typeof e[Symbol.iterator]!="function")throw new TypeError("values is not iterable");e=Array.from(e);let[n]=t;if(n&&n.length!==2||t.length>1){let i=Uint32Array.from(e,(r,s)=>s);return t.length>1?(t=t.map(r=>e.map(r)),i.sort((r,s)=>{for(let o of t){let a=bl(o[r],o[s]);if(a)return a}})):(n=e.map(n),i.sort((r,s)=>bl(n[r],n[s]))),FA(e,i)}return e.sort(x_(n))}function x_(e=tn){if(e===tn)return bl;if(typeof e!="function")throw new TypeError("compare is not a function");return(t,n)=>{let i=e(t,n);return i||i===0?i:(e(n,n)===0)-(e(t,t)===0)}}function bl(e,t){return(e==null||!(e>=e))-(t==null||!(t>=t))||(e<t?-1:e>t?1:0)}function wl(e,t,n){return(t.length!==2?yo(Ji(e,t,n),([i,r],[s,o])=>tn(r,o)||tn(i,s)):yo(ms(e,n),([i,r],[s,o])=>t(r,o)||tn(i,s))).map(([i])=>i)}var OA=Array.prototype,hk=OA.slice;var BA=Math.sqrt(50),kA=Math.sqrt(10),zA=Math.sqrt(2);function Ml(e,t,n){let i=(t-e)/Math.max(0,n),r=Math.floor(Math.log10(i)),s=i/Math.pow(10,r),o=s>=BA?10:s>=kA?5:s>=zA?2:1,a,c,l;return r<0?(l=Math.pow(10,-r)/o,a=Math.round(e*l),c=Math.round(t*l),a/l<e&&++a,c/l>t&&--c,l=-l):(l=Math.pow(10,r)*o,a=Math.round(e/l),c=Math.round(t/l),a*l<e&&++a,c*l>t&&--c),c<a&&.5<=n&&n<2?Ml(e,t,n*2):[a,c,l]}function Pr(e,t,n){if(t=+t,e=+e,n=+n,!(n>0))return[];if(e===t)return[e];let i=t<e,[r,s,o]=i?Ml(t,e,n):Ml(e,t,n);if(!(s>=r))return[];let a=s-r+1,c=new Array(a);if(i)if(o<0)for(let l=0;l<a;++l)c[l]=(s-l)/-o;else for(let l=0;l<a;++l)c[l]=(s-l)*o;else if(o<0)for(let l=0;l<a;++l)c[l]=(r+l)/-o;else for(let l=0;l<a;++l)c[l]=(r+l)*o;return c}function xo(e,t,n){return t=+t,e=+e,n=+n,Ml(e,t,n)[2]}function qa(e,t,n){t=+t,e=+e,n=+n;let i=t<e,r=i?xo(t,e,n):xo(e,t,n);return(i?-1:1)*(r<0?1/-r:r)}function __(e){return Math.max(1,Math.ceil(Math.log(Zh(e))/Math.LN2)+1)}function sn(e,t){let n;if(t===void 0)for(let i of e)i!=null&&(n<i||n===void 0&&i>=i)&&(n=i);else{let i=-1;for(let r of e)(r=t(r,++i,e))!=null&&(n<r||n===void 0&&r>=r)&&(n=r)}return n}function v_(e,t){let n,i=-1,r=-1;if(t===void 0)for(let s of e)++r,s!=null&&(n<s||n===void 0&&s>=s)&&(n=s,i=r);else for(let s of e)(s=t(s,++r,e))!=null&&(n<s||n===void 0&&s>=s)&&(n=s,i=r);return i}function Bn(e,t){let n;if(t===void 0)for(let i of e)i!=null&&(n>i||n===void 0&&i>=i)&&(n=i);else{let i=-1;for(let r of e)(r=t(r,++i,e))!=null&&(n>r||n===void 0&&r>=r)&&(n=r)}return n}function b_(e,t){let n,i=-1,r=-1;if(t===void 0)for(let s of e)++r,s!=null&&(n>s||n===void 0&&s>=s)&&(n=s,i=r);else for(let s of e)(s=t(s,++r,e))!=null&&(n>s||n===void 0&&s>=s)&&(n=s,i=r);return i}function M_(e,t,n=0,i=1/0,r){if(t=Math.floor(t),n=Math.floor(Math.max(0,n)),i=Math.floor(Math.min(e.length-1,i)),!(n<=t&&t<=i))return e;for(r=r===void 0?bl:x_(r);i>n;){if(i-n>600){let c=i-n+1,l=t-n+1,u=Math.log(c),h=.5*Math.exp(2*u/3),f=.5*Math.sqrt(u*h*(c-h)/c)*(l-c/2<0?-1:1),d=Math.max(n,Math.floor(t-l*h/c+f)),m=Math.min(i,Math.floor(t+(c-l)*h/c+f));M_(e,t,d,m,r)}let s=e[t],o=n,a=i;for(Ya(e,n,t),r(e[i],s)>0&&Ya(e,n,i);o<a;){for(Ya(e,o,a),++o,--a;r(e[o],s)<0;)++o;for(;r(e[a],s)>0;)--a}r(e[n],s)===0?Ya(e,n,a):(++a,Ya(e,a,i)),a<=t&&(n=a+1),t<=a&&(i=a-1)}return e}function Ya(e,t,n){let i=e[t];e[t]=e[n],e[n]=i}function Qh(e,t=tn){let n,i=!1;if(t.length===1){let r;for(let s of e){let o=t(s);(i?tn(o,r)>0:tn(o,o)===0)&&(n=s,r=o,i=!0)}}else for(let r of e)(i?t(r,n)>0:t(r,r)===0)&&(n=r,i=!0);return n}function qi(e,t,n){if(e=Float64Array.from(RA(e,n)),!(!(i=e.length)||isNaN(t=+t))){if(t<=0||i<2)return Bn(e);if(t>=1)return sn(e);var i,r=(i-1)*t,s=Math.floor(r),o=sn(M_(e,s).subarray(0,s+1)),a=Bn(e.subarray(s+1));return o+(a-o)*(r-s)}}function w_(e,t,n=c_){if(!(!(i=e.length)||isNaN(t=+t))){if(t<=0||i<2)return+n(e[0],0,e);if(t>=1)return+n(e[i-1],i-1,e);var i,r=(i-1)*t,s=Math.floor(r),o=+n(e[s],s,e),a=+n(e[s+1],s+1,e);return o+(a-o)*(r-s)}}function S_(e,t,n){let i=Zh(e),r=qi(e,.75)-qi(e,.25);return i&&r?Math.ceil((n-t)/(2*r*Math.pow(i,-1/3))):1}function td(e,t,n){let i=Zh(e),r=Kh(e);return i&&r?Math.ceil((n-t)*Math.cbrt(i)/(3.49*r)):1}function T_(e,t){let n=0,i=0;if(t===void 0)for(let r of e)r!=null&&(r=+r)>=r&&(++n,i+=r);else{let r=-1;for(let s of e)(s=t(s,++r,e))!=null&&(s=+s)>=s&&(++n,i+=s)}if(n)return i/n}function Za(e,t){return qi(e,.5,t)}function*VA(e){for(let t of e)yield*t}function ed(e){return Array.from(VA(e))}function E_(e,t){let n=new On;if(t===void 0)for(let s of e)s!=null&&s>=s&&n.set(s,(n.get(s)||0)+1);else{let s=-1;for(let o of e)(o=t(o,++s,e))!=null&&o>=o&&n.set(o,(n.get(o)||0)+1)}let i,r=0;for(let[s,o]of n)o>r&&(r=o,i=s);return i}function A_(e,t=HA){let n=[],i,r=!1;for(let s of e)r&&n.push(t(i,s)),i=s,r=!0;return n}function HA(e,t){return[e,t]}function bo(e,t,n){e=+e,t=+t,n=(r=arguments.length)<2?(t=e,e=0,1):r<3?1:+n;for(var i=-1,r=Math.max(0,Math.ceil((t-e)/n))|0,s=new Array(r);++i<r;)s[i]=e+i*n;return s}var dk=GA(Math.random);function GA(e){return function(n,i=0,r=n.length){let s=r-(i=+i);for(;s;){let o=e()*s--|0,a=n[s+i];n[s+i]=n[o+i],n[o+i]=a}return n}}function ri(e,t){let n=0;if(t===void 0)for(let i of e)(i=+i)&&(n+=i);else{let i=-1;for(let r of e)(r=+t(r,++i,e))&&(n+=r)}return n}function Mo(e){if(typeof e[Symbol.iterator]!="function")throw new TypeError("values is not iterable");return Array.from(e).reverse()}function WA(e){return e}var nd=1,id=2,rd=3,Sl=4,C_=1e-6;function $A(e){return"translate("+e+",0)"}function XA(e){return"translate(0,"+e+")"}function YA(e){return t=>+e(t)}function qA(e,t){return t=Math.max(0,e.bandwidth()-t*2)/2,e.round()&&(t=Math.round(t)),n=>+e(n)+t}function ZA(){return!this.__axis}function JA(e,t){var n=[],i=null,r=null,s=6,o=6,a=3,c=typeof window<"u"&&window.devicePixelRatio>1?0:.5,l=e===nd||e===Sl?-1:1,u=e===Sl||e===id?"x":"y",h=e===nd||e===rd?$A:XA;function f(d){var m=i??(t.ticks?t.ticks.apply(t,n):t.domain()),y=r??(t.tickFormat?t.tickFormat.apply(t,n):WA),g=Math.max(s,0)+a,p=t.range(),_=+p[0]+c,b=+p[p.length-1]+c,x=(t.bandwidth?qA:YA)(t.copy(),c),C=d.selection?d.selection():d,w=C.selectAll(".domain").data([null]),S=C.selectAll(".tick").data(m,t).order(),R=S.exit(),M=S.enter().append("g").attr("class","tick"),v=S.select("line"),E=S.select("text");w=w.merge(w.enter().insert("path",".tick").attr("class","domain").attr("stroke","currentColor")),S=S.merge(M),v=v.merge(M.append("line").attr("stroke","currentColor").attr(u+"2",l*s)),E=E.merge(M.append("text").attr("fill","currentColor").attr(u,l*g).attr("dy",e===nd?"0em":e===rd?"0.71em":"0.32em")),d!==C&&(w=w.transition(d),S=S.transition(d),v=v.transition(d),E=E.transition(d),R=R.transition(d).attr("opacity",C_).attr("transform",function(N){return isFinite(N=x(N))?h(N+c):this.getAttribute("transform")}),M.attr("opacity",C_).attr("transform",function(N){var U=this.parentNode.__axis;return h((U&&isFinite(U=U(N))?U:x(N))+c)})),R.remove(),w.attr("d",e===Sl||e===id?o?"M"+l*o+","+_+"H"+c+"V"+b+"H"+l*o:"M"+c+","+_+"V"+b:o?"M"+_+","+l*o+"V"+c+"H"+b+"V"+l*o:"M"+_+","+c+"H"+b),S.attr("opacity",1).attr("transform",function(N){return h(x(N)+c)}),v.attr(u+"2",l*s),E.attr(u,l*g).text(y),C.filter(ZA).attr("fill","none").attr("font-size",10).attr("font-family","sans-serif").attr("text-anchor",e===id?"start":e===Sl?"end":"middle"),C.each(function(){this.__axis=x})}return f.scale=function(d){return arguments.length?(t=d,f):t},f.ticks=function(){return n=Array.from(arguments),f},f.tickArguments=function(d){return arguments.length?(n=d==null?[]:Array.from(d),f):n.slice()},f.tickValues=function(d){return arguments.length?(i=d==null?null:Array.from(d),f):i&&i.slice()},f.tickFormat=function(d){return arguments.length?(r=d,f):r},f.tickSize=function(d){return arguments.length?(s=o=+d,f):s},f.tickSizeInner=function(d){return arguments.length?(s=+d,f):s},f.tickSizeOuter=function(d){return arguments.length?(o=+d,f):o},f.tickPadding=function(d){return arguments.length?(a=+d,f):a},f.offset=function(d){return arguments.length?(c=+d,f):c},f}function R_(e){return JA(rd,e)}var sd="http://www.w3.org/1999/xhtml",Lr={svg:"http://www.w3.org/2000/svg",xhtml:sd,xlink:"http://www.w3.org/1999/xlink",xml:"http://www.w3.org/XML/1998/namespace",xmlns:"http://www.w3.org/2000/xmlns/"};function I_(e){var t=e+="",n=t.indexOf(":");return n>=0&&(t=e.slice(0,n))!=="xmlns"&&(e=e.slice(n+1)),Lr.hasOwnProperty(t)?{space:Lr[t],local:e}:e}function KA(e){return function(){var t=this.ownerDocument,n=this.namespaceURI;return n===sd&&t.documentElement.namespaceURI===sd?t.createElement(e):t.createElementNS(n,e)}}function jA(e){return function(){return this.ownerDocument.createElementNS(e.space,e.local)}}function wo(e){var t=I_(e);return(t.local?jA:KA)(t)}function QA(){}function P_(e){return e==null?QA:function(){return this.querySelector(e)}}function tC(e){typeof e!="function"&&(e=P_(e));for(var t=this._groups,n=t.length,i=new Array(n),r=0;r<n;++r)for(var s=t[r],o=s.length,a=i[r]=new Array(o),c,l,u=0;u<o;++u)(c=s[u])&&(l=e.call(c,c.__data__,u,s))&&("__data__"in c&&(l.__data__=c.__data__),a[u]=l);return new Tn(i,this._parents)}function eC(e){return e==null?[]:Array.isArray(e)?e:Array.from(e)}function nC(){return[]}function iC(e){return e==null?nC:function(){return this.querySelectorAll(e)}}function rC(e){return function(){return eC(e.apply(this,arguments))}}function sC(e){typeof e=="function"?e=rC(e):e=iC(e);for(var t=this._groups,n=t.length,i=[],r=[],s=0;s<n;++s)for(var o=t[s],a=o.length,c,l=0;l<a;++l)(c=o[l])&&(i.push(e.call(c,c.__data__,l,o)),r.push(c));return new Tn(i,r)}function oC(e){return function(){return this.matches(e)}}function L_(e){return function(t){return t.matches(e)}}var aC=Array.prototype.find;function cC(e){return function(){return aC.call(this.children,e)}}function lC(){return this.firstElementChild}function uC(e){return this.select(e==null?lC:cC(typeof e=="function"?e:L_(e)))}var fC=Array.prototype.filter;function hC(){return Array.from(this.children)}function dC(e){return function(){return fC.call(this.children,e)}}function pC(e){return this.selectAll(e==null?hC:dC(typeof e=="function"?e:L_(e)))}function mC(e){typeof e!="function"&&(e=oC(e));for(var t=this._groups,n=t.length,i=new Array(n),r=0;r<n;++r)for(var s=t[r],o=s.length,a=i[r]=[],c,l=0;l<o;++l)(c=s[l])&&e.call(c,c.__data__,l,s)&&a.push(c);return new Tn(i,this._parents)}function N_(e){return new Array(e.length)}function gC(){return new Tn(this._enter||this._groups.map(N_),this._parents)}function Tl(e,t){this.ownerDocument=e.ownerDocument,this.namespaceURI=e.namespaceURI,this._next=null,this._parent=e,this.__data__=t}Tl.prototype={constructor:Tl,appendChild:function(e){return this._parent.insertBefore(e,this._next)},insertBefore:function(e,t){return this._parent.insertBefore(e,t)},querySelector:function(e){return this._parent.querySelector(e)},querySelectorAll:function(e){return this._parent.querySelectorAll(e)}};function yC(e){return function(){return e}}function xC(e,t,n,i,r,s){for(var o=0,a,c=t.length,l=s.length;o<l;++o)(a=t[o])?(a.__data__=s[o],i[o]=a):n[o]=new Tl(e,s[o]);for(;o<c;++o)(a=t[o])&&(r[o]=a)}function _C(e,t,n,i,r,s,o){var a,c,l=new Map,u=t.length,h=s.length,f=new Array(u),d;for(a=0;a<u;++a)(c=t[a])&&(f[a]=d=o.call(c,c.__data__,a,t)+"",l.has(d)?r[a]=c:l.set(d,c));for(a=0;a<h;++a)d=o.call(e,s[a],a,s)+"",(c=l.get(d))?(i[a]=c,c.__data__=s[a],l.delete(d)):n[a]=new Tl(e,s[a]);for(a=0;a<u;++a)(c=t[a])&&l.get(f[a])===c&&(r[a]=c)}function vC(e){return e.__data__}function bC(e,t){if(!arguments.length)return Array.from(this,vC);var n=t?_C:xC,i=this._parents,r=this._groups;typeof e!="function"&&(e=yC(e));for(var s=r.length,o=new Array(s),a=new Array(s),c=new Array(s),l=0;l<s;++l){var u=i[l],h=r[l],f=h.length,d=MC(e.call(u,u&&u.__data__,l,i)),m=d.length,y=a[l]=new Array(m),g=o[l]=new Array(m),p=c[l]=new Array(f);n(u,h,y,g,p,d,t);for(var _=0,b=0,x,C;_<m;++_)if(x=y[_]){for(_>=b&&(b=_+1);!(C=g[b])&&++b<m;);x._next=C||null}}return o=new Tn(o,i),o._enter=a,o._exit=c,o}function MC(e){return typeof e=="object"&&"length"in e?e:Array.from(e)}function wC(){return new Tn(this._exit||this._groups.map(N_),this._parents)}function SC(e,t,n){var i=this.enter(),r=this,s=this.exit();return typeof e=="function"?(i=e(i),i&&(i=i.selection())):i=i.append(e+""),t!=null&&(r=t(r),r&&(r=r.selection())),n==null?s.remove():n(s),i&&r?i.merge(r).order():r}function TC(e){for(var t=e.selection?e.selection():e,n=this._groups,i=t._groups,r=n.length,s=i.length,o=Math.min(r,s),a=new Array(r),c=0;c<o;++c)for(var l=n[c],u=i[c],h=l.length,f=a[c]=new Array(h),d,m=0;m<h;++m)(d=l[m]||u[m])&&(f[m]=d);for(;c<r;++c)a[c]=n[c];return new Tn(a,this._parents)}function EC(){for(var e=this._groups,t=-1,n=e.length;++t<n;)for(var i=e[t],r=i.length-1,s=i[r],o;--r>=0;)(o=i[r])&&(s&&o.compareDocumentPosition(s)^4&&s.parentNode.insertBefore(o,s),s=o);return this}function AC(e){e||(e=CC);function t(h,f){return h&&f?e(h.__data__,f.__data__):!h-!f}for(var n=this._groups,i=n.length,r=new Array(i),s=0;s<i;++s){for(var o=n[s],a=o.length,c=r[s]=new Array(a),l,u=0;u<a;++u)(l=o[u])&&(c[u]=l);c.sort(t)}return new Tn(r,this._parents).order()}function CC(e,t){return e<t?-1:e>t?1:e>=t?0:NaN}function RC(){var e=arguments[0];return arguments[0]=this,e.apply(null,arguments),this}function IC(){return Array.from(this)}function PC(){for(var e=this._groups,t=0,n=e.length;t<n;++t)for(var i=e[t],r=0,s=i.length;r<s;++r){var o=i[r];if(o)return o}return null}function LC(){let e=0;for(let t of this)++e;return e}function NC(){return!this.node()}function DC(e){for(var t=this._groups,n=0,i=t.length;n<i;++n)for(var r=t[n],s=0,o=r.length,a;s<o;++s)(a=r[s])&&e.call(a,a.__data__,s,r);return this}function UC(e){return function(){this.removeAttribute(e)}}function FC(e){return function(){this.removeAttributeNS(e.space,e.local)}}function OC(e,t){return function(){this.setAttribute(e,t)}}function BC(e,t){return function(){this.setAttributeNS(e.space,e.local,t)}}function kC(e,t){return function(){var n=t.apply(this,arguments);n==null?this.removeAttribute(e):this.setAttribute(e,n)}}function zC(e,t){return function(){var n=t.apply(this,arguments);n==null?this.removeAttributeNS(e.space,e.local):this.setAttributeNS(e.space,e.local,n)}}function VC(e,t){var n=I_(e);if(arguments.length<2){var i=this.node();return n.local?i.getAttributeNS(n.space,n.local):i.getAttribute(n)}return this.each((t==null?n.local?FC:UC:typeof t=="function"?n.local?zC:kC:n.local?BC:OC)(n,t))}function D_(e){return e.ownerDocument&&e.ownerDocument.defaultView||e.document&&e||e.defaultView}function HC(e){return function(){this.style.removeProperty(e)}}function GC(e,t,n){return function(){this.style.setProperty(e,t,n)}}function WC(e,t,n){return function(){var i=t.apply(this,arguments);i==null?this.style.removeProperty(e):this.style.setProperty(e,i,n)}}function $C(e,t,n){return arguments.length>1?this.each((t==null?HC:typeof t=="function"?WC:GC)(e,t,n??"")):XC(this.node(),e)}function XC(e,t){return e.style.getPropertyValue(t)||D_(e).getComputedStyle(e,null).getPropertyValue(t)}function YC(e){return function(){delete this[e]}}function qC(e,t){return function(){this[e]=t}}function ZC(e,t){return function(){var n=t.apply(this,arguments);n==null?delete this[e]:this[e]=n}}function JC(e,t){return arguments.length>1?this.each((t==null?YC:typeof t=="function"?ZC:qC)(e,t)):this.node()[e]}function U_(e){return e.trim().split(/^|\s+/)}function ad(e){return e.classList||new F_(e)}function F_(e){this._node=e,this._names=U_(e.getAttribute("class")||"")}F_.prototype={add:function(e){var t=this._names.indexOf(e);t<0&&(this._names.push(e),this._node.setAttribute("class",this._names.join(" ")))},remove:function(e){var t=this._names.indexOf(e);t>=0&&(this._names.splice(t,1),this._node.setAttribute("class",this._names.join(" ")))},contains:function(e){return this._names.indexOf(e)>=0}};function O_(e,t){for(var n=ad(e),i=-1,r=t.length;++i<r;)n.add(t[i])}function B_(e,t){for(var n=ad(e),i=-1,r=t.length;++i<r;)n.remove(t[i])}function KC(e){return function(){O_(this,e)}}function jC(e){return function(){B_(this,e)}}function QC(e,t){return function(){(t.apply(this,arguments)?O_:B_)(this,e)}}function t3(e,t){var n=U_(e+"");if(arguments.length<2){for(var i=ad(this.node()),r=-1,s=n.length;++r<s;)if(!i.contains(n[r]))return!1;return!0}return this.each((typeof t=="function"?QC:t?KC:jC)(n,t))}function e3(){this.textContent=""}function n3(e){return function(){this.textContent=e}}function i3(e){return function(){var t=e.apply(this,arguments);this.textContent=t??""}}function r3(e){return arguments.length?this.each(e==null?e3:(typeof e=="function"?i3:n3)(e)):this.node().textContent}function s3(){this.innerHTML=""}function o3(e){return function(){this.innerHTML=e}}function a3(e){return function(){var t=e.apply(this,arguments);this.innerHTML=t??""}}function c3(e){return arguments.length?this.each(e==null?s3:(typeof e=="function"?a3:o3)(e)):this.node().innerHTML}function l3(){this.nextSibling&&this.parentNode.appendChild(this)}function u3(){return this.each(l3)}function f3(){this.previousSibling&&this.parentNode.insertBefore(this,this.parentNode.firstChild)}function h3(){return this.each(f3)}function d3(e){var t=typeof e=="function"?e:wo(e);return this.select(function(){return this.appendChild(t.apply(this,arguments))})}function p3(){return null}function m3(e,t){var n=typeof e=="function"?e:wo(e),i=t==null?p3:typeof t=="function"?t:P_(t);return this.select(function(){return this.insertBefore(n.apply(this,arguments),i.apply(this,arguments)||null)})}function g3(){var e=this.parentNode;e&&e.removeChild(this)}function y3(){return this.each(g3)}function x3(){var e=this.cloneNode(!1),t=this.parentNode;return t?t.insertBefore(e,this.nextSibling):e}function _3(){var e=this.cloneNode(!0),t=this.parentNode;return t?t.insertBefore(e,this.nextSibling):e}function v3(e){return this.select(e?_3:x3)}function b3(e){return arguments.length?this.property("__data__",e):this.node().__data__}function M3(e){return function(t){e.call(this,t,this.__data__)}}function w3(e){return e.trim().split(/^|\s+/).map(function(t){var n="",i=t.indexOf(".");return i>=0&&(n=t.slice(i+1),t=t.slice(0,i)),{type:t,name:n}})}function S3(e){return function(){var t=this.__on;if(t){for(var n=0,i=-1,r=t.length,s;n<r;++n)s=t[n],(!e.type||s.type===e.type)&&s.name===e.name?this.removeEventListener(s.type,s.listener,s.options):t[++i]=s;++i?t.length=i:delete this.__on}}}function T3(e,t,n){return function(){var i=this.__on,r,s=M3(t);if(i){for(var o=0,a=i.length;o<a;++o)if((r=i[o]).type===e.type&&r.name===e.name){this.removeEventListener(r.type,r.listener,r.options),this.addEventListener(r.type,r.listener=s,r.options=n),r.value=t;return}}this.addEventListener(e.type,s,n),r={type:e.type,name:e.name,value:t,listener:s,options:n},i?i.push(r):this.__on=[r]}}function E3(e,t,n){var i=w3(e+""),r,s=i.length,o;if(arguments.length<2){var a=this.node().__on;if(a){for(var c=0,l=a.length,u;c<l;++c)for(r=0,u=a[c];r<s;++r)if((o=i[r]).type===u.type&&o.name===u.name)return u.value}return}for(a=t?T3:S3,r=0;r<s;++r)this.each(a(i[r],t,n));return this}function k_(e,t,n){var i=D_(e),r=i.CustomEvent;typeof r=="function"?r=new r(t,n):(r=i.document.createEvent("Event"),n?(r.initEvent(t,n.bubbles,n.cancelable),r.detail=n.detail):r.initEvent(t,!1,!1)),e.dispatchEvent(r)}function A3(e,t){return function(){return k_(this,e,t)}}function C3(e,t){return function(){return k_(this,e,t.apply(this,arguments))}}function R3(e,t){return this.each((typeof t=="function"?C3:A3)(e,t))}function*I3(){for(var e=this._groups,t=0,n=e.length;t<n;++t)for(var i=e[t],r=0,s=i.length,o;r<s;++r)(o=i[r])&&(yield o)}var z_=[null];function Tn(e,t){this._groups=e,this._parents=t}function P3(){return new Tn([[document.documentElement]],z_)}function L3(){return this}Tn.prototype=P3.prototype={constructor:Tn,select:tC,selectAll:sC,selectChild:uC,selectChildren:pC,filter:mC,data:bC,enter:gC,exit:wC,join:SC,merge:TC,selection:L3,order:EC,sort:AC,call:RC,nodes:IC,node:PC,size:LC,empty:NC,each:DC,attr:VC,style:$C,property:JC,classed:t3,text:r3,html:c3,raise:u3,lower:h3,append:d3,insert:m3,remove:y3,clone:v3,datum:b3,on:E3,dispatch:R3,[Symbol.iterator]:I3};function si(e){return typeof e=="string"?new Tn([[document.querySelector(e)]],[document.documentElement]):new Tn([[e]],z_)}var N3=0;function D3(){return new od}function od(){this._="@"+(++N3).toString(36)}od.prototype=D3.prototype={constructor:od,get:function(e){for(var t=this._;!(t in e);)if(!(e=e.parentNode))return;return e[t]},set:function(e,t){return e[this._]=t},remove:function(e){return this._ in e&&delete e[this._]},toString:function(){return this._}};function U3(e){let t;for(;t=e.sourceEvent;)e=t;return e}function V_(e,t){if(e=U3(e),t===void 0&&(t=e.currentTarget),t){var n=t.ownerSVGElement||t;if(n.createSVGPoint){var i=n.createSVGPoint();return i.x=e.clientX,i.y=e.clientY,i=i.matrixTransform(t.getScreenCTM().inverse()),[i.x,i.y]}if(t.getBoundingClientRect){var r=t.getBoundingClientRect();return[e.clientX-r.left-t.clientLeft,e.clientY-r.top-t.clientTop]}}return[e.pageX,e.pageY]}function Ao(e,t,n){e.prototype=t.prototype=n,n.constructor=e}function ja(e,t){var n=Object.create(e.prototype);for(var i in t)n[i]=t[i];return n}function Nr(){}var _s=.7,Eo=1/_s,So="\\s*([+-]?\\d+)\\s*",Ja="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)\\s*",wi="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)%\\s*",F3=/^#([0-9a-f]{3,8})$/,O3=new RegExp(`^rgb\\(${So},${So},${So}\\)$`),B3=new RegExp(`^rgb\\(${wi},${wi},${wi}\\)$`),k3=new RegExp(`^rgba\\(${So},${So},${So},${Ja}\\)$`),z3=new RegExp(`^rgba\\(${wi},${wi},${wi},${Ja}\\)$`),V3=new RegExp(`^hsl\\(${Ja},${wi},${wi}\\)$`),H3=new RegExp(`^hsla\\(${Ja},${wi},${wi},${Ja}\\)$`),H_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074};Ao(Nr,Co,{copy(e){return Object.assign(new this.constructor,this,e)},displayable(){return this.rgb().displayable()},hex:G_,formatHex:G_,formatHex8:G3,formatHsl:W3,formatRgb:W_,toString:W_});function G_(){return this.rgb().formatHex()}function G3(){return this.rgb().formatHex8()}function W3(){return Q_(this).formatHsl()}function W_(){return this.rgb().formatRgb()}function Co(e){var t,n;return e=(e+"").trim().toLowerCase(),(t=F3.exec(e))?(n=t[1].length,t=parseInt(t[1],16),n===6?$_(t):n===3?new He(t>>8&15|t>>4&240,t>>4&15|t&240,(t&15)<<4|t&15,1):n===8?El(t>>24&255,t>>16&255,t>>8&255,(t&255)/255):n===4?El(t>>12&15|t>>8&240,t>>8&15|t>>4&240,t>>4&15|t&240,((t&15)<<4|t&15)/255):null):(t=O3.exec(e))?new He(t[1],t[2],t[3],1):(t=B3.exec(e))?new He(t[1]*255/100,t[2]*255/100,t[3]*255/100,1):(t=k3.exec(e))?El(t[1],t[2],t[3],t[4]):(t=z3.exec(e))?El(t[1]*255/100,t[2]*255/100,t[3]*255/100,t[4]):(t=V3.exec(e))?q_(t[1],t[2]/100,t[3]/100,1):(t=H3.exec(e))?q_(t[1],t[2]/100,t[3]/100,t[4]):H_.hasOwnProperty(e)?$_(H_[e]):e==="transparent"?new He(NaN,NaN,NaN,0):null}function $_(e){return new He(e>>16&255,e>>8&255,e&255,1)}function El(e,t,n,i){return i<=0&&(e=t=n=NaN),new He(e,t,n,i)}function dd(e){return e instanceof Nr||(e=Co(e)),e?(e=e.rgb(),new He(e.r,e.g,e.b,e.opacity)):new He}function ai(e,t,n,i){return arguments.length===1?dd(e):new He(e,t,n,i??1)}function He(e,t,n,i){this.r=+e,this.g=+t,this.b=+n,this.opacity=+i}Ao(He,ai,ja(Nr,{brighter(e){return e=e==null?Eo:Math.pow(Eo,e),new He(this.r*e,this.g*e,this.b*e,this.opacity)},darker(e){return e=e==null?_s:Math.pow(_s,e),new He(this.r*e,this.g*e,this.b*e,this.opacity)},rgb(){return this},clamp(){return new He(ys(this.r),ys(this.g),ys(this.b),Cl(this.opacity))},displayable(){return-.5<=this.r&&this.r<255.5&&-.5<=this.g&&this.g<255.5&&-.5<=this.b&&this.b<255.5&&0<=this.opacity&&this.opacity<=1},hex:X_,formatHex:X_,formatHex8:$3,formatRgb:Y_,toString:Y_}));function X_(){return`#${gs(this.r)}${gs(this.g)}${gs(this.b)}`}function $3(){return`#${gs(this.r)}${gs(this.g)}${gs(this.b)}${gs((isNaN(this.opacity)?1:this.opacity)*255)}`}function Y_(){let e=Cl(this.opacity);return`${e===1?"rgb(":"rgba("}${ys(this.r)}, ${ys(this.g)}, ${ys(this.b)}${e===1?")":`, ${e})`}`}function Cl(e){return isNaN(e)?1:Math.max(0,Math.min(1,e))}function ys(e){return Math.max(0,Math.min(255,Math.round(e)||0))}function gs(e){return e=ys(e),(e<16?"0":"")+e.toString(16)}function q_(e,t,n,i){return i<=0?e=t=n=NaN:n<=0||n>=1?e=t=NaN:t<=0&&(e=NaN),new oi(e,t,n,i)}function Q_(e){if(e instanceof oi)return new oi(e.h,e.s,e.l,e.opacity);if(e instanceof Nr||(e=Co(e)),!e)return new oi;if(e instanceof oi)return e;e=e.rgb();var t=e.r/255,n=e.g/255,i=e.b/255,r=Math.min(t,n,i),s=Math.max(t,n,i),o=NaN,a=s-r,c=(s+r)/2;return a?(t===s?o=(n-i)/a+(n<i)*6:n===s?o=(i-t)/a+2:o=(t-n)/a+4,a/=c<.5?s+r:2-s-r,o*=60):a=c>0&&c<1?0:o,new oi(o,a,c,e.opacity)}function Il(e,t,n,i){return arguments.length===1?Q_(e):new oi(e,t,n,i??1)}function oi(e,t,n,i){this.h=+e,this.s=+t,this.l=+n,this.opacity=+i}Ao(oi,Il,ja(Nr,{brighter(e){return e=e==null?Eo:Math.pow(Eo,e),new oi(this.h,this.s,this.l*e,this.opacity)},darker(e){return e=e==null?_s:Math.pow(_s,e),new oi(this.h,this.s,this.l*e,this.opacity)},rgb(){var e=this.h%360+(this.h<0)*360,t=isNaN(e)||isNaN(this.s)?0:this.s,n=this.l,i=n+(n<.5?n:1-n)*t,r=2*n-i;return new He(cd(e>=240?e-240:e+120,r,i),cd(e,r,i),cd(e<120?e+240:e-120,r,i),this.opacity)},clamp(){return new oi(Z_(this.h),Al(this.s),Al(this.l),Cl(this.opacity))},displayable(){return(0<=this.s&&this.s<=1||isNaN(this.s))&&0<=this.l&&this.l<=1&&0<=this.opacity&&this.opacity<=1},formatHsl(){let e=Cl(this.opacity);return`${e===1?"hsl(":"hsla("}${Z_(this.h)}, ${Al(this.s)*100}%, ${Al(this.l)*100}%${e===1?")":`, ${e})`}`}}));function Z_(e){return e=(e||0)%360,e<0?e+360:e}function Al(e){return Math.max(0,Math.min(1,e||0))}function cd(e,t,n){return(e<60?t+(n-t)*e/60:e<180?n:e<240?t+(n-t)*(240-e)/60:t)*255}var tv=Math.PI/180,ev=180/Math.PI,Rl=18,nv=.96422,iv=1,rv=.82521,sv=4/29,To=6/29,ov=3*To*To,X3=To*To*To;function av(e){if(e instanceof Si)return new Si(e.l,e.a,e.b,e.opacity);if(e instanceof Ki)return cv(e);e instanceof He||(e=dd(e));var t=hd(e.r),n=hd(e.g),i=hd(e.b),r=ld((.2225045*t+.7168786*n+.0606169*i)/iv),s,o;return t===n&&n===i?s=o=r:(s=ld((.4360747*t+.3850649*n+.1430804*i)/nv),o=ld((.0139322*t+.0971045*n+.7141733*i)/rv)),new Si(116*r-16,500*(s-r),200*(r-o),e.opacity)}function Pl(e,t,n,i){return arguments.length===1?av(e):new Si(e,t,n,i??1)}function Si(e,t,n,i){this.l=+e,this.a=+t,this.b=+n,this.opacity=+i}Ao(Si,Pl,ja(Nr,{brighter(e){return new Si(this.l+Rl*(e??1),this.a,this.b,this.opacity)},darker(e){return new Si(this.l-Rl*(e??1),this.a,this.b,this.opacity)},rgb(){var e=(this.l+16)/116,t=isNaN(this.a)?e:e+this.a/500,n=isNaN(this.b)?e:e-this.b/200;return t=nv*ud(t),e=iv*ud(e),n=rv*ud(n),new He(fd(3.1338561*t-1.6168667*e-.4906146*n),fd(-.9787684*t+1.9161415*e+.033454*n),fd(.0719453*t-.2289914*e+1.4052427*n),this.opacity)}}));function ld(e){return e>X3?Math.pow(e,1/3):e/ov+sv}function ud(e){return e>To?e*e*e:ov*(e-sv)}function fd(e){return 255*(e<=.0031308?12.92*e:1.055*Math.pow(e,1/2.4)-.055)}function hd(e){return(e/=255)<=.04045?e/12.92:Math.pow((e+.055)/1.055,2.4)}function Y3(e){if(e instanceof Ki)return new Ki(e.h,e.c,e.l,e.opacity);if(e instanceof Si||(e=av(e)),e.a===0&&e.b===0)return new Ki(NaN,0<e.l&&e.l<100?0:NaN,e.l,e.opacity);var t=Math.atan2(e.b,e.a)*ev;return new Ki(t<0?t+360:t,Math.sqrt(e.a*e.a+e.b*e.b),e.l,e.opacity)}function Ll(e,t,n,i){return arguments.length===1?Y3(e):new Ki(e,t,n,i??1)}function Ki(e,t,n,i){this.h=+e,this.c=+t,this.l=+n,this.opacity=+i}function cv(e){if(isNaN(e.h))return new Si(e.l,0,0,e.opacity);var t=e.h*tv;return new Si(e.l,Math.cos(t)*e.c,Math.sin(t)*e.c,e.opacity)}Ao(Ki,Ll,ja(Nr,{brighter(e){return new Ki(this.h,this.c,this.l+Rl*(e??1),this.opacity)},darker(e){return new Ki(this.h,this.c,this.l-Rl*(e??1),this.opacity)},rgb(){return cv(this).rgb()}}));var lv=-.14861,pd=1.78277,md=-.29227,Nl=-.90649,Ka=1.97294,J_=Ka*Nl,K_=Ka*pd,j_=pd*md-Nl*lv;function q3(e){if(e instanceof xs)return new xs(e.h,e.s,e.l,e.opacity);e instanceof He||(e=dd(e));var t=e.r/255,n=e.g/255,i=e.b/255,r=(j_*i+J_*t-K_*n)/(j_+J_-K_),s=i-r,o=(Ka*(n-r)-md*s)/Nl,a=Math.sqrt(o*o+s*s)/(Ka*r*(1-r)),c=a?Math.atan2(o,s)*ev-120:NaN;return new xs(c<0?c+360:c,a,r,e.opacity)}function kn(e,t,n,i){return arguments.length===1?q3(e):new xs(e,t,n,i??1)}function xs(e,t,n,i){this.h=+e,this.s=+t,this.l=+n,this.opacity=+i}Ao(xs,kn,ja(Nr,{brighter(e){return e=e==null?Eo:Math.pow(Eo,e),new xs(this.h,this.s,this.l*e,this.opacity)},darker(e){return e=e==null?_s:Math.pow(_s,e),new xs(this.h,this.s,this.l*e,this.opacity)},rgb(){var e=isNaN(this.h)?0:(this.h+120)*tv,t=+this.l,n=isNaN(this.s)?0:this.s*t*(1-t),i=Math.cos(e),r=Math.sin(e);return new He(255*(t+n*(lv*i+pd*r)),255*(t+n*(md*i+Nl*r)),255*(t+n*(Ka*i)),this.opacity)}}));function hv(e,t,n,i,r){var s=e*e,o=s*e;return((1-3*e+3*s-o)*t+(4-6*s+3*o)*n+(1+3*e+3*s-3*o)*i+o*r)/6}function Z3(e){var t=e.length-1;return function(n){var i=n<=0?n=0:n>=1?(n=1,t-1):Math.floor(n*t),r=e[i],s=e[i+1],o=i>0?e[i-1]:2*r-s,a=i<t-1?e[i+2]:2*s-r;return hv((n-i/t)*t,o,r,s,a)}}function J3(e){var t=e.length;return function(n){var i=Math.floor(((n%=1)<0?++n:n)*t),r=e[(i+t-1)%t],s=e[i%t],o=e[(i+1)%t],a=e[(i+2)%t];return hv((n-i/t)*t,r,s,o,a)}}var Ul=e=>()=>e;function dv(e,t){return function(n){return e+n*t}}function K3(e,t,n){return e=Math.pow(e,n),t=Math.pow(t,n)-e,n=1/n,function(i){return Math.pow(e+i*t,n)}}function _d(e,t){var n=t-e;return n?dv(e,n>180||n<-180?n-360*Math.round(n/360):n):Ul(isNaN(e)?t:e)}function j3(e){return(e=+e)==1?Ge:function(t,n){return n-t?K3(t,n,e):Ul(isNaN(t)?n:t)}}function Ge(e,t){var n=t-e;return n?dv(e,n):Ul(isNaN(e)?t:e)}var vs=function e(t){var n=j3(t);function i(r,s){var o=n((r=ai(r)).r,(s=ai(s)).r),a=n(r.g,s.g),c=n(r.b,s.b),l=Ge(r.opacity,s.opacity);return function(u){return r.r=o(u),r.g=a(u),r.b=c(u),r.opacity=l(u),r+""}}return i.gamma=e,i}(1);function pv(e){return function(t){var n=t.length,i=new Array(n),r=new Array(n),s=new Array(n),o,a;for(o=0;o<n;++o)a=ai(t[o]),i[o]=a.r||0,r[o]=a.g||0,s[o]=a.b||0;return i=e(i),r=e(r),s=e(s),a.opacity=1,function(c){return a.r=i(c),a.g=r(c),a.b=s(c),a+""}}}var mv=pv(Z3),_k=pv(J3);function Q3(e,t){t||(t=[]);var n=e?Math.min(t.length,e.length):0,i=t.slice(),r;return function(s){for(r=0;r<n;++r)i[r]=e[r]*(1-s)+t[r]*s;return i}}function tR(e){return ArrayBuffer.isView(e)&&!(e instanceof DataView)}function eR(e,t){var n=t?t.length:0,i=e?Math.min(n,e.length):0,r=new Array(i),s=new Array(n),o;for(o=0;o<i;++o)r[o]=Ro(e[o],t[o]);for(;o<n;++o)s[o]=t[o];return function(a){for(o=0;o<i;++o)s[o]=r[o](a);return s}}function nR(e,t){var n=new Date;return e=+e,t=+t,function(i){return n.setTime(e*(1-i)+t*i),n}}function Oe(e,t){return e=+e,t=+t,function(n){return e*(1-n)+t*n}}function iR(e,t){var n={},i={},r;(e===null||typeof e!="object")&&(e={}),(t===null||typeof t!="object")&&(t={});for(r in t)r in e?n[r]=Ro(e[r],t[r]):i[r]=t[r];return function(s){for(r in n)i[r]=n[r](s);return i}}var yd=/[-+]?(?:\d+\.?\d*|\.?\d+)(?:[eE][-+]?\d+)?/g,gd=new RegExp(yd.source,"g");function rR(e){return function(){return e}}function sR(e){return function(t){return e(t)+""}}function oR(e,t){var n=yd.lastIndex=gd.lastIndex=0,i,r,s,o=-1,a=[],c=[];for(e=e+"",t=t+"";(i=yd.exec(e))&&(r=gd.exec(t));)(s=r.index)>n&&(s=t.slice(n,s),a[o]?a[o]+=s:a[++o]=s),(i=i[0])===(r=r[0])?a[o]?a[o]+=r:a[++o]=r:(a[++o]=null,c.push({i:o,x:Oe(i,r)})),n=gd.lastIndex;return n<t.length&&(s=t.slice(n),a[o]?a[o]+=s:a[++o]=s),a.length<2?c[0]?sR(c[0].x):rR(t):(t=c.length,function(l){for(var u=0,h;u<t;++u)a[(h=c[u]).i]=h.x(l);return a.join("")})}function Ro(e,t){var n=typeof t,i;return t==null||n==="boolean"?Ul(t):(n==="number"?Oe:n==="string"?(i=Co(t))?(t=i,vs):oR:t instanceof Co?vs:t instanceof Date?nR:tR(t)?Q3:Array.isArray(t)?eR:typeof t.valueOf!="function"&&typeof t.toString!="function"||isNaN(t)?iR:Oe)(e,t)}function Qa(e,t){return e=+e,t=+t,function(n){return Math.round(e*(1-n)+t*n)}}var uv=180/Math.PI,xd={translateX:0,translateY:0,rotate:0,skewX:0,scaleX:1,scaleY:1};function gv(e,t,n,i,r,s){var o,a,c;return(o=Math.sqrt(e*e+t*t))&&(e/=o,t/=o),(c=e*n+t*i)&&(n-=e*c,i-=t*c),(a=Math.sqrt(n*n+i*i))&&(n/=a,i/=a,c/=a),e*i<t*n&&(e=-e,t=-t,c=-c,o=-o),{translateX:r,translateY:s,rotate:Math.atan2(t,e)*uv,skewX:Math.atan(c)*uv,scaleX:o,scaleY:a}}var Dl;function aR(e){let t=new(typeof DOMMatrix=="function"?DOMMatrix:WebKitCSSMatrix)(e+"");return t.isIdentity?xd:gv(t.a,t.b,t.c,t.d,t.e,t.f)}function cR(e){return e==null||(Dl||(Dl=document.createElementNS("http://www.w3.org/2000/svg","g")),Dl.setAttribute("transform",e),!(e=Dl.transform.baseVal.consolidate()))?xd:(e=e.matrix,gv(e.a,e.b,e.c,e.d,e.e,e.f))}function yv(e,t,n,i){function r(l){return l.length?l.pop()+" ":""}function s(l,u,h,f,d,m){if(l!==h||u!==f){var y=d.push("translate(",null,t,null,n);m.push({i:y-4,x:Oe(l,h)},{i:y-2,x:Oe(u,f)})}else(h||f)&&d.push("translate("+h+t+f+n)}function o(l,u,h,f){l!==u?(l-u>180?u+=360:u-l>180&&(l+=360),f.push({i:h.push(r(h)+"rotate(",null,i)-2,x:Oe(l,u)})):u&&h.push(r(h)+"rotate("+u+i)}function a(l,u,h,f){l!==u?f.push({i:h.push(r(h)+"skewX(",null,i)-2,x:Oe(l,u)}):u&&h.push(r(h)+"skewX("+u+i)}function c(l,u,h,f,d,m){if(l!==h||u!==f){var y=d.push(r(d)+"scale(",null,",",null,")");m.push({i:y-4,x:Oe(l,h)},{i:y-2,x:Oe(u,f)})}else(h!==1||f!==1)&&d.push(r(d)+"scale("+h+","+f+")")}return function(l,u){var h=[],f=[];return l=e(l),u=e(u),s(l.translateX,l.translateY,u.translateX,u.translateY,h,f),o(l.rotate,u.rotate,h,f),a(l.skewX,u.skewX,h,f),c(l.scaleX,l.scaleY,u.scaleX,u.scaleY,h,f),l=u=null,function(d){for(var m=-1,y=f.length,g;++m<y;)h[(g=f[m]).i]=g.x(d);return h.join("")}}}var vk=yv(aR,"px, ","px)","deg)"),bk=yv(cR,", ",")",")"),lR=1e-12;function fv(e){return((e=Math.exp(e))+1/e)/2}function uR(e){return((e=Math.exp(e))-1/e)/2}function fR(e){return((e=Math.exp(2*e))-1)/(e+1)}var Mk=function e(t,n,i){function r(s,o){var a=s[0],c=s[1],l=s[2],u=o[0],h=o[1],f=o[2],d=u-a,m=h-c,y=d*d+m*m,g,p;if(y<lR)p=Math.log(f/l)/t,g=function(S){return[a+S*d,c+S*m,l*Math.exp(t*S*p)]};else{var _=Math.sqrt(y),b=(f*f-l*l+i*y)/(2*l*n*_),x=(f*f-l*l-i*y)/(2*f*n*_),C=Math.log(Math.sqrt(b*b+1)-b),w=Math.log(Math.sqrt(x*x+1)-x);p=(w-C)/t,g=function(S){var R=S*p,M=fv(C),v=l/(n*_)*(M*fR(t*R+C)-uR(C));return[a+v*d,c+v*m,l*M/fv(t*R+C)]}}return g.duration=Math.abs(p)*1e3*t/Math.SQRT2,g}return r.rho=function(s){var o=Math.max(.001,+s),a=o*o,c=a*a;return e(o,a,c)},r}(Math.SQRT2,2,4);function xv(e){return function(t,n){var i=e((t=Il(t)).h,(n=Il(n)).h),r=Ge(t.s,n.s),s=Ge(t.l,n.l),o=Ge(t.opacity,n.opacity);return function(a){return t.h=i(a),t.s=r(a),t.l=s(a),t.opacity=o(a),t+""}}}var _v=xv(_d),wk=xv(Ge);function vv(e,t){var n=Ge((e=Pl(e)).l,(t=Pl(t)).l),i=Ge(e.a,t.a),r=Ge(e.b,t.b),s=Ge(e.opacity,t.opacity);return function(o){return e.l=n(o),e.a=i(o),e.b=r(o),e.opacity=s(o),e+""}}function bv(e){return function(t,n){var i=e((t=Ll(t)).h,(n=Ll(n)).h),r=Ge(t.c,n.c),s=Ge(t.l,n.l),o=Ge(t.opacity,n.opacity);return function(a){return t.h=i(a),t.c=r(a),t.l=s(a),t.opacity=o(a),t+""}}}var Mv=bv(_d),Sk=bv(Ge);function wv(e){return function t(n){n=+n;function i(r,s){var o=e((r=kn(r)).h,(s=kn(s)).h),a=Ge(r.s,s.s),c=Ge(r.l,s.l),l=Ge(r.opacity,s.opacity);return function(u){return r.h=o(u),r.s=a(u),r.l=c(Math.pow(u,n)),r.opacity=l(u),r+""}}return i.gamma=t,i}(1)}var Tk=wv(_d),Fl=wv(Ge);function Dr(e,t){t===void 0&&(t=e,e=Ro);for(var n=0,i=t.length-1,r=t[0],s=new Array(i<0?0:i);n<i;)s[n]=e(r,r=t[++n]);return function(o){var a=Math.max(0,Math.min(i-1,Math.floor(o*=i)));return s[a](o-a)}}function on(e,t){for(var n=new Array(t),i=0;i<t;++i)n[i]=e(i/(t-1));return n}var tc=Math.PI,vd=2*tc,bs=1e-6,hR=vd-bs;function Sv(e){this._+=e[0];for(let t=1,n=e.length;t<n;++t)this._+=arguments[t]+e[t]}function dR(e){let t=Math.floor(e);if(!(t>=0))throw new Error(`invalid digits: ${e}`);if(t>15)return Sv;let n=10**t;return function(i){this._+=i[0];for(let r=1,s=i.length;r<s;++r)this._+=Math.round(arguments[r]*n)/n+i[r]}}function Tv(e,t,n,i){return e===n&&t===i}function pR(e){let t=Math.floor(e);if(!(t<=15))return Tv;let n=10**t,i=function(r){return Math.round(r*n)};return function(r,s,o,a){return i(r)===i(o)&&i(s)===i(a)}}var Ms=class{constructor(t){this._x0=this._y0=this._x1=this._y1=null,this._="",this._append=t==null?Sv:dR(t),this._equal=t==null?Tv:pR(t)}moveTo(t,n){this._append`M${this._x0=this._x1=+t},${this._y0=this._y1=+n}`}closePath(){this._x1!==null&&(this._x1=this._x0,this._y1=this._y0,this._append`Z`)}lineTo(t,n){this._append`L${this._x1=+t},${this._y1=+n}`}quadraticCurveTo(t,n,i,r){this._append`Q${+t},${+n},${this._x1=+i},${this._y1=+r}`}bezierCurveTo(t,n,i,r,s,o){this._append`C${+t},${+n},${+i},${+r},${this._x1=+s},${this._y1=+o}`}arcTo(t,n,i,r,s){if(t=+t,n=+n,i=+i,r=+r,s=+s,s<0)throw new Error(`negative radius: ${s}`);let o=this._x1,a=this._y1,c=i-t,l=r-n,u=o-t,h=a-n,f=u*u+h*h;if(this._x1===null)this._append`M${this._x1=t},${this._y1=n}`;else if(f>bs)if(!(Math.abs(h*c-l*u)>bs)||!s)this._append`L${this._x1=t},${this._y1=n}`;else{let d=i-o,m=r-a,y=c*c+l*l,g=d*d+m*m,p=Math.sqrt(y),_=Math.sqrt(f),b=s*Math.tan((tc-Math.acos((y+f-g)/(2*p*_)))/2),x=b/_,C=b/p;Math.abs(x-1)>bs&&this._append`L${t+x*u},${n+x*h}`,this._append`A${s},${s},0,0,${+(h*d>u*m)},${this._x1=t+C*c},${this._y1=n+C*l}`}}arc(t,n,i,r,s,o){if(t=+t,n=+n,i=+i,o=!!o,i<0)throw new Error(`negative radius: ${i}`);let a=i*Math.cos(r),c=i*Math.sin(r),l=t+a,u=n+c,h=1^o,f=o?r-s:s-r;if(this._x1===null?this._append`M${l},${u}`:(Math.abs(this._x1-l)>bs||Math.abs(this._y1-u)>bs)&&this._append`L${l},${u}`,!!i){if(f<0&&(f=f%vd+vd),f>hR)this._append`A${i},${i},0,1,${h},${t-a},${n-c}A${i},${i},0,1,${h},${this._x1=l},${this._y1=u}`;else if(f>bs){let d=t+i*Math.cos(s),m=n+i*Math.sin(s);if(f>=tc&&this._equal(l,u,d,m)){f/=2;let y=r+f;this._append`A${i},${i},0,${+(f>=tc)},${h},${t+i*Math.cos(y)},${n+i*Math.sin(y)}`}this._append`A${i},${i},0,${+(f>=tc)},${h},${this._x1=d},${this._y1=m}`}}}rect(t,n,i,r){this._append`M${this._x0=this._x1=+t},${this._y0=this._y1=+n}h${i=+i}v${+r}h${-i}Z`}toString(){return this._}};function mR(){return new Ms}mR.prototype=Ms.prototype;function Ti(e=3){return new Ms(+e)}function gR(e){return Math.abs(e=Math.round(e))>=1e21?e.toLocaleString("en").replace(/,/g,""):e.toString(10)}function Bl(e,t){if(!isFinite(e)||e===0)return null;var n=(e=t?e.toExponential(t-1):e.toExponential()).indexOf("e"),i=e.slice(0,n);return[i.length>1?i[0]+i.slice(2):i,+e.slice(n+1)]}function Io(e){return e=Bl(Math.abs(e)),e?e[1]:NaN}function yR(e,t){return function(n,i){for(var r=n.length,s=[],o=0,a=e[0],c=0;r>0&&a>0&&(c+a+1>i&&(a=Math.max(1,i-c)),s.push(n.substring(r-=a,r+a)),!((c+=a+1)>i));)a=e[o=(o+1)%e.length];return s.reverse().join(t)}}function xR(e){return function(t){return t.replace(/[0-9]/g,function(n){return e[+n]})}}var _R=/^(?:(.)?([<>=^]))?([+\-( ])?([$#])?(0)?(\d+)?(,)?(\.\d+)?(~)?([a-z%])?$/i;function Po(e){if(!(t=_R.exec(e)))throw new Error("invalid format: "+e);var t;return new bd({fill:t[1],align:t[2],sign:t[3],symbol:t[4],zero:t[5],width:t[6],comma:t[7],precision:t[8]&&t[8].slice(1),trim:t[9],type:t[10]})}Po.prototype=bd.prototype;function bd(e){this.fill=e.fill===void 0?" ":e.fill+"",this.align=e.align===void 0?">":e.align+"",this.sign=e.sign===void 0?"-":e.sign+"",this.symbol=e.symbol===void 0?"":e.symbol+"",this.zero=!!e.zero,this.width=e.width===void 0?void 0:+e.width,this.comma=!!e.comma,this.precision=e.precision===void 0?void 0:+e.precision,this.trim=!!e.trim,this.type=e.type===void 0?"":e.type+""}bd.prototype.toString=function(){return this.fill+this.align+this.sign+this.symbol+(this.zero?"0":"")+(this.width===void 0?"":Math.max(1,this.width|0))+(this.comma?",":"")+(this.precision===void 0?"":"."+Math.max(0,this.precision|0))+(this.trim?"~":"")+this.type};function vR(e){t:for(var t=e.length,n=1,i=-1,r;n<t;++n)switch(e[n]){case".":i=r=n;break;case"0":i===0&&(i=n),r=n;break;default:if(!+e[n])break t;i>0&&(i=0);break}return i>0?e.slice(0,i)+e.slice(r+1):e}var kl;function bR(e,t){var n=Bl(e,t);if(!n)return kl=void 0,e.toPrecision(t);var i=n[0],r=n[1],s=r-(kl=Math.max(-8,Math.min(8,Math.floor(r/3)))*3)+1,o=i.length;return s===o?i:s>o?i+new Array(s-o+1).join("0"):s>0?i.slice(0,s)+"."+i.slice(s):"0."+new Array(1-s).join("0")+Bl(e,Math.max(0,t+s-1))[0]}function Ev(e,t){var n=Bl(e,t);if(!n)return e+"";var i=n[0],r=n[1];return r<0?"0."+new Array(-r).join("0")+i:i.length>r+1?i.slice(0,r+1)+"."+i.slice(r+1):i+new Array(r-i.length+2).join("0")}var Av={"%":(e,t)=>(e*100).toFixed(t),b:e=>Math.round(e).toString(2),c:e=>e+"",d:gR,e:(e,t)=>e.toExponential(t),f:(e,t)=>e.toFixed(t),g:(e,t)=>e.toPrecision(t),o:e=>Math.round(e).toString(8),p:(e,t)=>Ev(e*100,t),r:Ev,s:bR,X:e=>Math.round(e).toString(16).toUpperCase(),x:e=>Math.round(e).toString(16)};function Cv(e){return e}var Rv=Array.prototype.map,Iv=["y","z","a","f","p","n","µ","m","","k","M","G","T","P","E","Z","Y"];function MR(e){var t=e.grouping===void 0||e.thousands===void 0?Cv:yR(Rv.call(e.grouping,Number),e.thousands+""),n=e.currency===void 0?"":e.currency[0]+"",i=e.currency===void 0?"":e.currency[1]+"",r=e.decimal===void 0?".":e.decimal+"",s=e.numerals===void 0?Cv:xR(Rv.call(e.numerals,String)),o=e.percent===void 0?"%":e.percent+"",a=e.minus===void 0?"−":e.minus+"",c=e.nan===void 0?"NaN":e.nan+"";function l(h,f){h=Po(h);var d=h.fill,m=h.align,y=h.sign,g=h.symbol,p=h.zero,_=h.width,b=h.comma,x=h.precision,C=h.trim,w=h.type;w==="n"?(b=!0,w="g"):Av[w]||(x===void 0&&(x=12),C=!0,w="g"),(p||d==="0"&&m==="=")&&(p=!0,d="0",m="=");var S=(f&&f.prefix!==void 0?f.prefix:"")+(g==="$"?n:g==="#"&&/[boxX]/.test(w)?"0"+w.toLowerCase():""),R=(g==="$"?i:/[%p]/.test(w)?o:"")+(f&&f.suffix!==void 0?f.suffix:""),M=Av[w],v=/[defgprs%]/.test(w);x=x===void 0?6:/[gprs]/.test(w)?Math.max(1,Math.min(21,x)):Math.max(0,Math.min(20,x));function E(N){var U=S,F=R,P,O,H;if(w==="c")F=M(N)+F,N="";else{N=+N;var z=N<0||1/N<0;if(N=isNaN(N)?c:M(Math.abs(N),x),C&&(N=vR(N)),z&&+N==0&&y!=="+"&&(z=!1),U=(z?y==="("?y:a:y==="-"||y==="("?"":y)+U,F=(w==="s"&&!isNaN(N)&&kl!==void 0?Iv[8+kl/3]:"")+F+(z&&y==="("?")":""),v){for(P=-1,O=N.length;++P<O;)if(H=N.charCodeAt(P),48>H||H>57){F=(H===46?r+N.slice(P+1):N.slice(P))+F,N=N.slice(0,P);break}}}b&&!p&&(N=t(N,1/0));var G=U.length+N.length+F.length,j=G<_?new Array(_-G+1).join(d):"";switch(b&&p&&(N=t(j+N,j.length?_-F.length:1/0),j=""),m){case"<":N=U+N+F+j;break;case"=":N=U+j+N+F;break;case"^":N=j.slice(0,G=j.length>>1)+U+N+F+j.slice(G);break;default:N=j+U+N+F;break}return s(N)}return E.toString=function(){return h+""},E}function u(h,f){var d=Math.max(-8,Math.min(8,Math.floor(Io(f)/3)))*3,m=Math.pow(10,-d),y=l((h=Po(h),h.type="f",h),{suffix:Iv[8+d/3]});return function(g){return y(m*g)}}return{format:l,formatPrefix:u}}var Ol,Ei,Md;wR({thousands:",",grouping:[3],currency:["$",""]});function wR(e){return Ol=MR(e),Ei=Ol.format,Md=Ol.formatPrefix,Ol}function Pv(e){return Math.max(0,-Io(Math.abs(e)))}function Lv(e,t){return Math.max(0,Math.max(-8,Math.min(8,Math.floor(Io(t)/3)))*3-Io(Math.abs(e)))}function Nv(e,t){return e=Math.abs(e),t=Math.abs(t)-e,Math.max(0,Io(t)-Io(e))+1}var kt=1e-6,jv=1e-12,Zt=Math.PI,Ee=Zt/2,Dv=Zt/4,En=Zt*2,an=180/Zt,Te=Zt/180,oe=Math.abs,Uo=Math.atan,Qi=Math.atan2,qt=Math.cos;var Qv=Math.exp;var Xl=Math.log,wd=Math.pow,zt=Math.sin,Vn=Math.sign||function(e){return e>0?1:e<0?-1:0},mn=Math.sqrt,Gd=Math.tan;function tb(e){return e>1?0:e<-1?Zt:Math.acos(e)}function Gn(e){return e>1?Ee:e<-1?-Ee:Math.asin(e)}function Hn(){}function Yl(e,t){e&&Fv.hasOwnProperty(e.type)&&Fv[e.type](e,t)}var Uv={Feature:function(e,t){Yl(e.geometry,t)},FeatureCollection:function(e,t){for(var n=e.features,i=-1,r=n.length;++i<r;)Yl(n[i].geometry,t)}},Fv={Sphere:function(e,t){t.sphere()},Point:function(e,t){e=e.coordinates,t.point(e[0],e[1],e[2])},MultiPoint:function(e,t){for(var n=e.coordinates,i=-1,r=n.length;++i<r;)e=n[i],t.point(e[0],e[1],e[2])},LineString:function(e,t){Cd(e.coordinates,t,0)},MultiLineString:function(e,t){for(var n=e.coordinates,i=-1,r=n.length;++i<r;)Cd(n[i],t,0)},Polygon:function(e,t){Ov(e.coordinates,t)},MultiPolygon:function(e,t){for(var n=e.coordinates,i=-1,r=n.length;++i<r;)Ov(n[i],t)},GeometryCollection:function(e,t){for(var n=e.geometries,i=-1,r=n.length;++i<r;)Yl(n[i],t)}};function Cd(e,t,n){var i=-1,r=e.length-n,s;for(t.lineStart();++i<r;)s=e[i],t.point(s[0],s[1],s[2]);t.lineEnd()}function Ov(e,t){var n=-1,i=e.length;for(t.polygonStart();++n<i;)Cd(e[n],t,1);t.polygonEnd()}function Ur(e,t){e&&Uv.hasOwnProperty(e.type)?Uv[e.type](e,t):Yl(e,t)}var Ik=new Fn,Pk=new Fn;function Rd(e){return[Qi(e[1],e[0]),Gn(e[2])]}function No(e){var t=e[0],n=e[1],i=qt(n);return[i*qt(t),i*zt(t),zt(n)]}function zl(e,t){return e[0]*t[0]+e[1]*t[1]+e[2]*t[2]}function ql(e,t){return[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]]}function Sd(e,t){e[0]+=t[0],e[1]+=t[1],e[2]+=t[2]}function Vl(e,t){return[e[0]*t,e[1]*t,e[2]*t]}function Id(e){var t=mn(e[0]*e[0]+e[1]*e[1]+e[2]*e[2]);e[0]/=t,e[1]/=t,e[2]/=t}function Pd(e,t){function n(i,r){return i=e(i,r),t(i[0],i[1])}return e.invert&&t.invert&&(n.invert=function(i,r){return i=t.invert(i,r),i&&e.invert(i[0],i[1])}),n}function Ld(e,t){return oe(e)>Zt&&(e-=Math.round(e/En)*En),[e,t]}Ld.invert=Ld;function eb(e,t,n){return(e%=En)?t||n?Pd(kv(e),zv(t,n)):kv(e):t||n?zv(t,n):Ld}function Bv(e){return function(t,n){return t+=e,oe(t)>Zt&&(t-=Math.round(t/En)*En),[t,n]}}function kv(e){var t=Bv(e);return t.invert=Bv(-e),t}function zv(e,t){var n=qt(e),i=zt(e),r=qt(t),s=zt(t);function o(a,c){var l=qt(c),u=qt(a)*l,h=zt(a)*l,f=zt(c),d=f*n+u*i;return[Qi(h*r-d*s,u*n-f*i),Gn(d*r+h*s)]}return o.invert=function(a,c){var l=qt(c),u=qt(a)*l,h=zt(a)*l,f=zt(c),d=f*r-h*s;return[Qi(h*r+f*s,u*n+d*i),Gn(d*n-u*i)]},o}function SR(e){e=eb(e[0]*Te,e[1]*Te,e.length>2?e[2]*Te:0);function t(n){return n=e(n[0]*Te,n[1]*Te),n[0]*=an,n[1]*=an,n}return t.invert=function(n){return n=e.invert(n[0]*Te,n[1]*Te),n[0]*=an,n[1]*=an,n},t}function TR(e,t,n,i,r,s){if(n){var o=qt(t),a=zt(t),c=i*n;r==null?(r=t+i*En,s=t-c/2):(r=Vv(o,r),s=Vv(o,s),(i>0?r<s:r>s)&&(r+=i*En));for(var l,u=r;i>0?u>s:u<s;u-=c)l=Rd([o,-a*qt(u),-a*zt(u)]),e.point(l[0],l[1])}}function Vv(e,t){t=No(t),t[0]-=e,Id(t);var n=tb(-t[1]);return((-t[2]<0?-n:n)+En-kt)%En}function nb(){var e=[],t;return{point:function(n,i,r){t.push([n,i,r])},lineStart:function(){e.push(t=[])},lineEnd:Hn,rejoin:function(){e.length>1&&e.push(e.pop().concat(e.shift()))},result:function(){var n=e;return e=[],t=null,n}}}function $l(e,t){return oe(e[0]-t[0])<kt&&oe(e[1]-t[1])<kt}function Hl(e,t,n,i){this.x=e,this.z=t,this.o=n,this.e=i,this.v=!1,this.n=this.p=null}function ib(e,t,n,i,r){var s=[],o=[],a,c;if(e.forEach(function(m){if(!((y=m.length-1)<=0)){var y,g=m[0],p=m[y],_;if($l(g,p)){if(!g[2]&&!p[2]){for(r.lineStart(),a=0;a<y;++a)r.point((g=m[a])[0],g[1]);r.lineEnd();return}p[0]+=2*kt}s.push(_=new Hl(g,m,null,!0)),o.push(_.o=new Hl(g,null,_,!1)),s.push(_=new Hl(p,m,null,!1)),o.push(_.o=new Hl(p,null,_,!0))}}),!!s.length){for(o.sort(t),Hv(s),Hv(o),a=0,c=o.length;a<c;++a)o[a].e=n=!n;for(var l=s[0],u,h;;){for(var f=l,d=!0;f.v;)if((f=f.n)===l)return;u=f.z,r.lineStart();do{if(f.v=f.o.v=!0,f.e){if(d)for(a=0,c=u.length;a<c;++a)r.point((h=u[a])[0],h[1]);else i(f.x,f.n.x,1,r);f=f.n}else{if(d)for(u=f.p.z,a=u.length-1;a>=0;--a)r.point((h=u[a])[0],h[1]);else i(f.x,f.p.x,-1,r);f=f.p}f=f.o,u=f.z,d=!d}while(!f.v);r.lineEnd()}}}function Hv(e){if(t=e.length){for(var t,n=0,i=e[0],r;++n<t;)i.n=r=e[n],r.p=i,i=r;i.n=r=e[0],r.p=i}}function Td(e){return oe(e[0])<=Zt?e[0]:Vn(e[0])*((oe(e[0])+Zt)%En-Zt)}function ER(e,t){var n=Td(t),i=t[1],r=zt(i),s=[zt(n),-qt(n),0],o=0,a=0,c=new Fn;r===1?i=Ee+kt:r===-1&&(i=-Ee-kt);for(var l=0,u=e.length;l<u;++l)if(f=(h=e[l]).length)for(var h,f,d=h[f-1],m=Td(d),y=d[1]/2+Dv,g=zt(y),p=qt(y),_=0;_<f;++_,m=x,g=w,p=S,d=b){var b=h[_],x=Td(b),C=b[1]/2+Dv,w=zt(C),S=qt(C),R=x-m,M=R>=0?1:-1,v=M*R,E=v>Zt,N=g*w;if(c.add(Qi(N*M*zt(v),p*S+N*qt(v))),o+=E?R+M*En:R,E^m>=n^x>=n){var U=ql(No(d),No(b));Id(U);var F=ql(s,U);Id(F);var P=(E^R>=0?-1:1)*Gn(F[2]);(i>P||i===P&&(U[0]||U[1]))&&(a+=E^R>=0?1:-1)}}return(o<-kt||o<kt&&c<-jv)^a&1}function rb(e,t,n,i){return function(r){var s=t(r),o=nb(),a=t(o),c=!1,l,u,h,f={point:d,lineStart:y,lineEnd:g,polygonStart:function(){f.point=p,f.lineStart=_,f.lineEnd=b,u=[],l=[]},polygonEnd:function(){f.point=d,f.lineStart=y,f.lineEnd=g,u=ed(u);var x=ER(l,i);u.length?(c||(r.polygonStart(),c=!0),ib(u,CR,x,n,r)):x&&(c||(r.polygonStart(),c=!0),r.lineStart(),n(null,null,1,r),r.lineEnd()),c&&(r.polygonEnd(),c=!1),u=l=null},sphere:function(){r.polygonStart(),r.lineStart(),n(null,null,1,r),r.lineEnd(),r.polygonEnd()}};function d(x,C){e(x,C)&&r.point(x,C)}function m(x,C){s.point(x,C)}function y(){f.point=m,s.lineStart()}function g(){f.point=d,s.lineEnd()}function p(x,C){h.push([x,C]),a.point(x,C)}function _(){a.lineStart(),h=[]}function b(){p(h[0][0],h[0][1]),a.lineEnd();var x=a.clean(),C=o.result(),w,S=C.length,R,M,v;if(h.pop(),l.push(h),h=null,!!S){if(x&1){if(M=C[0],(R=M.length-1)>0){for(c||(r.polygonStart(),c=!0),r.lineStart(),w=0;w<R;++w)r.point((v=M[w])[0],v[1]);r.lineEnd()}return}S>1&&x&2&&C.push(C.pop().concat(C.shift())),u.push(C.filter(AR))}}return f}}function AR(e){return e.length>1}function CR(e,t){return((e=e.x)[0]<0?e[1]-Ee-kt:Ee-e[1])-((t=t.x)[0]<0?t[1]-Ee-kt:Ee-t[1])}var Gv=rb(function(){return!0},RR,PR,[-Zt,-Ee]);function RR(e){var t=NaN,n=NaN,i=NaN,r;return{lineStart:function(){e.lineStart(),r=1},point:function(s,o){var a=s>0?Zt:-Zt,c=oe(s-t);oe(c-Zt)<kt?(e.point(t,n=(n+o)/2>0?Ee:-Ee),e.point(i,n),e.lineEnd(),e.lineStart(),e.point(a,n),e.point(s,n),r=0):i!==a&&c>=Zt&&(oe(t-i)<kt&&(t-=i*kt),oe(s-a)<kt&&(s-=a*kt),n=IR(t,n,s,o),e.point(i,n),e.lineEnd(),e.lineStart(),e.point(a,n),r=0),e.point(t=s,n=o),i=a},lineEnd:function(){e.lineEnd(),t=n=NaN},clean:function(){return 2-r}}}function IR(e,t,n,i){var r,s,o=zt(e-n);return oe(o)>kt?Uo((zt(t)*(s=qt(i))*zt(n)-zt(i)*(r=qt(t))*zt(e))/(r*s*o)):(t+i)/2}function PR(e,t,n,i){var r;if(e==null)r=n*Ee,i.point(-Zt,r),i.point(0,r),i.point(Zt,r),i.point(Zt,0),i.point(Zt,-r),i.point(0,-r),i.point(-Zt,-r),i.point(-Zt,0),i.point(-Zt,r);else if(oe(e[0]-t[0])>kt){var s=e[0]<t[0]?Zt:-Zt;r=n*s/2,i.point(-s,r),i.point(0,r),i.point(s,r)}else i.point(t[0],t[1])}function LR(e){var t=qt(e),n=2*Te,i=t>0,r=oe(t)>kt;function s(u,h,f,d){TR(d,e,n,f,u,h)}function o(u,h){return qt(u)*qt(h)>t}function a(u){var h,f,d,m,y;return{lineStart:function(){m=d=!1,y=1},point:function(g,p){var _=[g,p],b,x=o(g,p),C=i?x?0:l(g,p):x?l(g+(g<0?Zt:-Zt),p):0;if(!h&&(m=d=x)&&u.lineStart(),x!==d&&(b=c(h,_),(!b||$l(h,b)||$l(_,b))&&(_[2]=1)),x!==d)y=0,x?(u.lineStart(),b=c(_,h),u.point(b[0],b[1])):(b=c(h,_),u.point(b[0],b[1],2),u.lineEnd()),h=b;else if(r&&h&&i^x){var w;!(C&f)&&(w=c(_,h,!0))&&(y=0,i?(u.lineStart(),u.point(w[0][0],w[0][1]),u.point(w[1][0],w[1][1]),u.lineEnd()):(u.point(w[1][0],w[1][1]),u.lineEnd(),u.lineStart(),u.point(w[0][0],w[0][1],3)))}x&&(!h||!$l(h,_))&&u.point(_[0],_[1]),h=_,d=x,f=C},lineEnd:function(){d&&u.lineEnd(),h=null},clean:function(){return y|(m&&d)<<1}}}function c(u,h,f){var d=No(u),m=No(h),y=[1,0,0],g=ql(d,m),p=zl(g,g),_=g[0],b=p-_*_;if(!b)return!f&&u;var x=t*p/b,C=-t*_/b,w=ql(y,g),S=Vl(y,x),R=Vl(g,C);Sd(S,R);var M=w,v=zl(S,M),E=zl(M,M),N=v*v-E*(zl(S,S)-1);if(!(N<0)){var U=mn(N),F=Vl(M,(-v-U)/E);if(Sd(F,S),F=Rd(F),!f)return F;var P=u[0],O=h[0],H=u[1],z=h[1],G;O<P&&(G=P,P=O,O=G);var j=O-P,nt=oe(j-Zt)<kt,ct=nt||j<kt;if(!nt&&z<H&&(G=H,H=z,z=G),ct?nt?H+z>0^F[1]<(oe(F[0]-P)<kt?H:z):H<=F[1]&&F[1]<=z:j>Zt^(P<=F[0]&&F[0]<=O)){var ft=Vl(M,(-v+U)/E);return Sd(ft,S),[F,Rd(ft)]}}}function l(u,h){var f=i?e:Zt-e,d=0;return u<-f?d|=1:u>f&&(d|=2),h<-f?d|=4:h>f&&(d|=8),d}return rb(o,a,s,i?[0,-e]:[-Zt,e-Zt])}function NR(e,t,n,i,r,s){var o=e[0],a=e[1],c=t[0],l=t[1],u=0,h=1,f=c-o,d=l-a,m;if(m=n-o,!(!f&&m>0)){if(m/=f,f<0){if(m<u)return;m<h&&(h=m)}else if(f>0){if(m>h)return;m>u&&(u=m)}if(m=r-o,!(!f&&m<0)){if(m/=f,f<0){if(m>h)return;m>u&&(u=m)}else if(f>0){if(m<u)return;m<h&&(h=m)}if(m=i-a,!(!d&&m>0)){if(m/=d,d<0){if(m<u)return;m<h&&(h=m)}else if(d>0){if(m>h)return;m>u&&(u=m)}if(m=s-a,!(!d&&m<0)){if(m/=d,d<0){if(m>h)return;m>u&&(u=m)}else if(d>0){if(m<u)return;m<h&&(h=m)}return u>0&&(e[0]=o+u*f,e[1]=a+u*d),h<1&&(t[0]=o+h*f,t[1]=a+h*d),!0}}}}}var ec=1e9,Gl=-ec;function Wd(e,t,n,i){function r(l,u){return e<=l&&l<=n&&t<=u&&u<=i}function s(l,u,h,f){var d=0,m=0;if(l==null||(d=o(l,h))!==(m=o(u,h))||c(l,u)<0^h>0)do f.point(d===0||d===3?e:n,d>1?i:t);while((d=(d+h+4)%4)!==m);else f.point(u[0],u[1])}function o(l,u){return oe(l[0]-e)<kt?u>0?0:3:oe(l[0]-n)<kt?u>0?2:1:oe(l[1]-t)<kt?u>0?1:0:u>0?3:2}function a(l,u){return c(l.x,u.x)}function c(l,u){var h=o(l,1),f=o(u,1);return h!==f?h-f:h===0?u[1]-l[1]:h===1?l[0]-u[0]:h===2?l[1]-u[1]:u[0]-l[0]}return function(l){var u=l,h=nb(),f,d,m,y,g,p,_,b,x,C,w,S={point:R,lineStart:N,lineEnd:U,polygonStart:v,polygonEnd:E};function R(P,O){r(P,O)&&u.point(P,O)}function M(){for(var P=0,O=0,H=d.length;O<H;++O)for(var z=d[O],G=1,j=z.length,nt=z[0],ct,ft,$=nt[0],tt=nt[1];G<j;++G)ct=$,ft=tt,nt=z[G],$=nt[0],tt=nt[1],ft<=i?tt>i&&($-ct)*(i-ft)>(tt-ft)*(e-ct)&&++P:tt<=i&&($-ct)*(i-ft)<(tt-ft)*(e-ct)&&--P;return P}function v(){u=h,f=[],d=[],w=!0}function E(){var P=M(),O=w&&P,H=(f=ed(f)).length;(O||H)&&(l.polygonStart(),O&&(l.lineStart(),s(null,null,1,l),l.lineEnd()),H&&ib(f,a,P,s,l),l.polygonEnd()),u=l,f=d=m=null}function N(){S.point=F,d&&d.push(m=[]),C=!0,x=!1,_=b=NaN}function U(){f&&(F(y,g),p&&x&&h.rejoin(),f.push(h.result())),S.point=R,x&&u.lineEnd()}function F(P,O){var H=r(P,O);if(d&&m.push([P,O]),C)y=P,g=O,p=H,C=!1,H&&(u.lineStart(),u.point(P,O));else if(H&&x)u.point(P,O);else{var z=[_=Math.max(Gl,Math.min(ec,_)),b=Math.max(Gl,Math.min(ec,b))],G=[P=Math.max(Gl,Math.min(ec,P)),O=Math.max(Gl,Math.min(ec,O))];NR(z,G,e,t,n,i)?(x||(u.lineStart(),u.point(z[0],z[1])),u.point(G[0],G[1]),H||u.lineEnd(),w=!1):H&&(u.lineStart(),u.point(P,O),w=!1)}_=P,b=O,x=H}return S}}var Nd=e=>e,Ed=new Fn,Dd=new Fn,sb,ob,Ud,Fd,ji={point:Hn,lineStart:Hn,lineEnd:Hn,polygonStart:function(){ji.lineStart=DR,ji.lineEnd=FR},polygonEnd:function(){ji.lineStart=ji.lineEnd=ji.point=Hn,Ed.add(oe(Dd)),Dd=new Fn},result:function(){var e=Ed/2;return Ed=new Fn,e}};function DR(){ji.point=UR}function UR(e,t){ji.point=ab,sb=Ud=e,ob=Fd=t}function ab(e,t){Dd.add(Fd*e-Ud*t),Ud=e,Fd=t}function FR(){ab(sb,ob)}var Do=1/0,Zl=Do,uc=-Do,Jl=uc,Kl={point:OR,lineStart:Hn,lineEnd:Hn,polygonStart:Hn,polygonEnd:Hn,result:function(){var e=[[Do,Zl],[uc,Jl]];return uc=Jl=-(Zl=Do=1/0),e}};function OR(e,t){e<Do&&(Do=e),e>uc&&(uc=e),t<Zl&&(Zl=t),t>Jl&&(Jl=t)}var Od=0,Bd=0,nc=0,jl=0,Ql=0,Lo=0,kd=0,zd=0,ic=0,cb,lb,Ai,Ci,zn={point:ws,lineStart:Wv,lineEnd:$v,polygonStart:function(){zn.lineStart=zR,zn.lineEnd=VR},polygonEnd:function(){zn.point=ws,zn.lineStart=Wv,zn.lineEnd=$v},result:function(){var e=ic?[kd/ic,zd/ic]:Lo?[jl/Lo,Ql/Lo]:nc?[Od/nc,Bd/nc]:[NaN,NaN];return Od=Bd=nc=jl=Ql=Lo=kd=zd=ic=0,e}};function ws(e,t){Od+=e,Bd+=t,++nc}function Wv(){zn.point=BR}function BR(e,t){zn.point=kR,ws(Ai=e,Ci=t)}function kR(e,t){var n=e-Ai,i=t-Ci,r=mn(n*n+i*i);jl+=r*(Ai+e)/2,Ql+=r*(Ci+t)/2,Lo+=r,ws(Ai=e,Ci=t)}function $v(){zn.point=ws}function zR(){zn.point=HR}function VR(){ub(cb,lb)}function HR(e,t){zn.point=ub,ws(cb=Ai=e,lb=Ci=t)}function ub(e,t){var n=e-Ai,i=t-Ci,r=mn(n*n+i*i);jl+=r*(Ai+e)/2,Ql+=r*(Ci+t)/2,Lo+=r,r=Ci*e-Ai*t,kd+=r*(Ai+e),zd+=r*(Ci+t),ic+=r*3,ws(Ai=e,Ci=t)}function fb(e){this._context=e}fb.prototype={_radius:4.5,pointRadius:function(e){return this._radius=e,this},polygonStart:function(){this._line=0},polygonEnd:function(){this._line=NaN},lineStart:function(){this._point=0},lineEnd:function(){this._line===0&&this._context.closePath(),this._point=NaN},point:function(e,t){switch(this._point){case 0:{this._context.moveTo(e,t),this._point=1;break}case 1:{this._context.lineTo(e,t);break}default:{this._context.moveTo(e+this._radius,t),this._context.arc(e,t,this._radius,0,En);break}}},result:Hn};var Vd=new Fn,Ad,hb,db,rc,sc,fc={point:Hn,lineStart:function(){fc.point=GR},lineEnd:function(){Ad&&pb(hb,db),fc.point=Hn},polygonStart:function(){Ad=!0},polygonEnd:function(){Ad=null},result:function(){var e=+Vd;return Vd=new Fn,e}};function GR(e,t){fc.point=pb,hb=rc=e,db=sc=t}function pb(e,t){rc-=e,sc-=t,Vd.add(mn(rc*rc+sc*sc)),rc=e,sc=t}var Xv,tu,Yv,qv,eu=class{constructor(t){this._append=t==null?mb:WR(t),this._radius=4.5,this._=""}pointRadius(t){return this._radius=+t,this}polygonStart(){this._line=0}polygonEnd(){this._line=NaN}lineStart(){this._point=0}lineEnd(){this._line===0&&(this._+="Z"),this._point=NaN}point(t,n){switch(this._point){case 0:{this._append`M${t},${n}`,this._point=1;break}case 1:{this._append`L${t},${n}`;break}default:{if(this._append`M${t},${n}`,this._radius!==Yv||this._append!==tu){let i=this._radius,r=this._;this._="",this._append`m0,${i}a${i},${i} 0 1,1 0,${-2*i}a${i},${i} 0 1,1 0,${2*i}z`,Yv=i,tu=this._append,qv=this._,this._=r}this._+=qv;break}}}result(){let t=this._;return this._="",t.length?t:null}};function mb(e){let t=1;this._+=e[0];for(let n=e.length;t<n;++t)this._+=arguments[t]+e[t]}function WR(e){let t=Math.floor(e);if(!(t>=0))throw new RangeError(`invalid digits: ${e}`);if(t>15)return mb;if(t!==Xv){let n=10**t;Xv=t,tu=function(r){let s=1;this._+=r[0];for(let o=r.length;s<o;++s)this._+=Math.round(arguments[s]*n)/n+r[s]}}return tu}function dc(e,t){let n=3,i=4.5,r,s;function o(a){return a&&(typeof i=="function"&&s.pointRadius(+i.apply(this,arguments)),Ur(a,r(s))),s.result()}return o.area=function(a){return Ur(a,r(ji)),ji.result()},o.measure=function(a){return Ur(a,r(fc)),fc.result()},o.bounds=function(a){return Ur(a,r(Kl)),Kl.result()},o.centroid=function(a){return Ur(a,r(zn)),zn.result()},o.projection=function(a){return arguments.length?(r=a==null?(e=null,Nd):(e=a).stream,o):e},o.context=function(a){return arguments.length?(s=a==null?(t=null,new eu(n)):new fb(t=a),typeof i!="function"&&s.pointRadius(i),o):t},o.pointRadius=function(a){return arguments.length?(i=typeof a=="function"?a:(s.pointRadius(+a),+a),o):i},o.digits=function(a){if(!arguments.length)return n;if(a==null)n=null;else{let c=Math.floor(a);if(!(c>=0))throw new RangeError(`invalid digits: ${a}`);n=c}return t===null&&(s=new eu(n)),o},o.projection(e).digits(n).context(t)}function pc(e){return{stream:ru(e)}}function ru(e){return function(t){var n=new Hd;for(var i in e)n[i]=e[i];return n.stream=t,n}}function Hd(){}Hd.prototype={constructor:Hd,point:function(e,t){this.stream.point(e,t)},sphere:function(){this.stream.sphere()},lineStart:function(){this.stream.lineStart()},lineEnd:function(){this.stream.lineEnd()},polygonStart:function(){this.stream.polygonStart()},polygonEnd:function(){this.stream.polygonEnd()}};function $d(e,t,n){var i=e.clipExtent&&e.clipExtent();return e.scale(150).translate([0,0]),i!=null&&e.clipExtent(null),Ur(n,e.stream(Kl)),t(Kl.result()),i!=null&&e.clipExtent(i),e}function Xd(e,t,n){return $d(e,function(i){var r=t[1][0]-t[0][0],s=t[1][1]-t[0][1],o=Math.min(r/(i[1][0]-i[0][0]),s/(i[1][1]-i[0][1])),a=+t[0][0]+(r-o*(i[1][0]+i[0][0]))/2,c=+t[0][1]+(s-o*(i[1][1]+i[0][1]))/2;e.scale(150*o).translate([a,c])},n)}function gb(e,t,n){return Xd(e,[[0,0],t],n)}function yb(e,t,n){return $d(e,function(i){var r=+t,s=r/(i[1][0]-i[0][0]),o=(r-s*(i[1][0]+i[0][0]))/2,a=-s*i[0][1];e.scale(150*s).translate([o,a])},n)}function xb(e,t,n){return $d(e,function(i){var r=+t,s=r/(i[1][1]-i[0][1]),o=-s*i[0][0],a=(r-s*(i[1][1]+i[0][1]))/2;e.scale(150*s).translate([o,a])},n)}var Zv=16,$R=qt(30*Te);function Jv(e,t){return+t?YR(e,t):XR(e)}function XR(e){return ru({point:function(t,n){t=e(t,n),this.stream.point(t[0],t[1])}})}function YR(e,t){function n(i,r,s,o,a,c,l,u,h,f,d,m,y,g){var p=l-i,_=u-r,b=p*p+_*_;if(b>4*t&&y--){var x=o+f,C=a+d,w=c+m,S=mn(x*x+C*C+w*w),R=Gn(w/=S),M=oe(oe(w)-1)<kt||oe(s-h)<kt?(s+h)/2:Qi(C,x),v=e(M,R),E=v[0],N=v[1],U=E-i,F=N-r,P=_*U-p*F;(P*P/b>t||oe((p*U+_*F)/b-.5)>.3||o*f+a*d+c*m<$R)&&(n(i,r,s,o,a,c,E,N,M,x/=S,C/=S,w,y,g),g.point(E,N),n(E,N,M,x,C,w,l,u,h,f,d,m,y,g))}}return function(i){var r,s,o,a,c,l,u,h,f,d,m,y,g={point:p,lineStart:_,lineEnd:x,polygonStart:function(){i.polygonStart(),g.lineStart=C},polygonEnd:function(){i.polygonEnd(),g.lineStart=_}};function p(R,M){R=e(R,M),i.point(R[0],R[1])}function _(){h=NaN,g.point=b,i.lineStart()}function b(R,M){var v=No([R,M]),E=e(R,M);n(h,f,u,d,m,y,h=E[0],f=E[1],u=R,d=v[0],m=v[1],y=v[2],Zv,i),i.point(h,f)}function x(){g.point=p,i.lineEnd()}function C(){_(),g.point=w,g.lineEnd=S}function w(R,M){b(r=R,M),s=h,o=f,a=d,c=m,l=y,g.point=b}function S(){n(h,f,u,d,m,y,s,o,r,a,c,l,Zv,i),g.lineEnd=x,x()}return g}}var qR=ru({point:function(e,t){this.stream.point(e*Te,t*Te)}});function ZR(e){return ru({point:function(t,n){var i=e(t,n);return this.stream.point(i[0],i[1])}})}function JR(e,t,n,i,r){function s(o,a){return o*=i,a*=r,[t+e*o,n-e*a]}return s.invert=function(o,a){return[(o-t)/e*i,(n-a)/e*r]},s}function Kv(e,t,n,i,r,s){if(!s)return JR(e,t,n,i,r);var o=qt(s),a=zt(s),c=o*e,l=a*e,u=o/e,h=a/e,f=(a*n-o*t)/e,d=(a*t+o*n)/e;function m(y,g){return y*=i,g*=r,[c*y-l*g+t,n-l*y-c*g]}return m.invert=function(y,g){return[i*(u*y-h*g+f),r*(d-h*y-u*g)]},m}function Fr(e){return _b(function(){return e})()}function _b(e){var t,n=150,i=480,r=250,s=0,o=0,a=0,c=0,l=0,u,h=0,f=1,d=1,m=null,y=Gv,g=null,p,_,b,x=Nd,C=.5,w,S,R,M,v;function E(P){return R(P[0]*Te,P[1]*Te)}function N(P){return P=R.invert(P[0],P[1]),P&&[P[0]*an,P[1]*an]}E.stream=function(P){return M&&v===P?M:M=qR(ZR(u)(y(w(x(v=P)))))},E.preclip=function(P){return arguments.length?(y=P,m=void 0,F()):y},E.postclip=function(P){return arguments.length?(x=P,g=p=_=b=null,F()):x},E.clipAngle=function(P){return arguments.length?(y=+P?LR(m=P*Te):(m=null,Gv),F()):m*an},E.clipExtent=function(P){return arguments.length?(x=P==null?(g=p=_=b=null,Nd):Wd(g=+P[0][0],p=+P[0][1],_=+P[1][0],b=+P[1][1]),F()):g==null?null:[[g,p],[_,b]]},E.scale=function(P){return arguments.length?(n=+P,U()):n},E.translate=function(P){return arguments.length?(i=+P[0],r=+P[1],U()):[i,r]},E.center=function(P){return arguments.length?(s=P[0]%360*Te,o=P[1]%360*Te,U()):[s*an,o*an]},E.rotate=function(P){return arguments.length?(a=P[0]%360*Te,c=P[1]%360*Te,l=P.length>2?P[2]%360*Te:0,U()):[a*an,c*an,l*an]},E.angle=function(P){return arguments.length?(h=P%360*Te,U()):h*an},E.reflectX=function(P){return arguments.length?(f=P?-1:1,U()):f<0},E.reflectY=function(P){return arguments.length?(d=P?-1:1,U()):d<0},E.precision=function(P){return arguments.length?(w=Jv(S,C=P*P),F()):mn(C)},E.fitExtent=function(P,O){return Xd(E,P,O)},E.fitSize=function(P,O){return gb(E,P,O)},E.fitWidth=function(P,O){return yb(E,P,O)},E.fitHeight=function(P,O){return xb(E,P,O)};function U(){var P=Kv(n,0,0,f,d,h).apply(null,t(s,o)),O=Kv(n,i-P[0],r-P[1],f,d,h);return u=eb(a,c,l),S=Pd(t,O),R=Pd(u,S),w=Jv(S,C),F()}function F(){return M=v=null,E}return function(){return t=e.apply(this,arguments),E.invert=t.invert&&N,U()}}function Yd(e){var t=0,n=Zt/3,i=_b(e),r=i(t,n);return r.parallels=function(s){return arguments.length?i(t=s[0]*Te,n=s[1]*Te):[t*an,n*an]},r}function KR(e){var t=qt(e);function n(i,r){return[i*t,zt(r)/t]}return n.invert=function(i,r){return[i/t,Gn(r*t)]},n}function jR(e,t){var n=zt(e),i=(n+zt(t))/2;if(oe(i)<kt)return KR(e);var r=1+n*(2*i-n),s=mn(r)/i;function o(a,c){var l=mn(r-2*i*zt(c))/i;return[l*zt(a*=i),s-l*qt(a)]}return o.invert=function(a,c){var l=s-c,u=Qi(a,oe(l))*Vn(l);return l*i<0&&(u-=Zt*Vn(a)*Vn(l)),[u/i,Gn((r-(a*a+l*l)*i*i)/(2*i))]},o}function hc(){return Yd(jR).scale(155.424).center([0,33.6442])}function qd(){return hc().parallels([29.5,45.5]).scale(1070).translate([480,250]).rotate([96,0]).center([-.6,38.7])}function QR(e){var t=e.length;return{point:function(n,i){for(var r=-1;++r<t;)e[r].point(n,i)},sphere:function(){for(var n=-1;++n<t;)e[n].sphere()},lineStart:function(){for(var n=-1;++n<t;)e[n].lineStart()},lineEnd:function(){for(var n=-1;++n<t;)e[n].lineEnd()},polygonStart:function(){for(var n=-1;++n<t;)e[n].polygonStart()},polygonEnd:function(){for(var n=-1;++n<t;)e[n].polygonEnd()}}}function vb(){var e,t,n=qd(),i,r=hc().rotate([154,0]).center([-2,58.5]).parallels([55,65]),s,o=hc().rotate([157,0]).center([-3,19.9]).parallels([8,18]),a,c,l={point:function(f,d){c=[f,d]}};function u(f){var d=f[0],m=f[1];return c=null,i.point(d,m),c||(s.point(d,m),c)||(a.point(d,m),c)}u.invert=function(f){var d=n.scale(),m=n.translate(),y=(f[0]-m[0])/d,g=(f[1]-m[1])/d;return(g>=.12&&g<.234&&y>=-.425&&y<-.214?r:g>=.166&&g<.234&&y>=-.214&&y<-.115?o:n).invert(f)},u.stream=function(f){return e&&t===f?e:e=QR([n.stream(t=f),r.stream(f),o.stream(f)])},u.precision=function(f){return arguments.length?(n.precision(f),r.precision(f),o.precision(f),h()):n.precision()},u.scale=function(f){return arguments.length?(n.scale(f),r.scale(f*.35),o.scale(f),u.translate(n.translate())):n.scale()},u.translate=function(f){if(!arguments.length)return n.translate();var d=n.scale(),m=+f[0],y=+f[1];return i=n.translate(f).clipExtent([[m-.455*d,y-.238*d],[m+.455*d,y+.238*d]]).stream(l),s=r.translate([m-.307*d,y+.201*d]).clipExtent([[m-.425*d+kt,y+.12*d+kt],[m-.214*d-kt,y+.234*d-kt]]).stream(l),a=o.translate([m-.205*d,y+.212*d]).clipExtent([[m-.214*d+kt,y+.166*d+kt],[m-.115*d-kt,y+.234*d-kt]]).stream(l),h()},u.fitExtent=function(f,d){return Xd(u,f,d)},u.fitSize=function(f,d){return gb(u,f,d)},u.fitWidth=function(f,d){return yb(u,f,d)},u.fitHeight=function(f,d){return xb(u,f,d)};function h(){return e=t=null,u}return u.scale(1070)}function bb(e){return function(t,n){var i=qt(t),r=qt(n),s=e(i*r);return s===1/0?[2,0]:[s*r*zt(t),s*zt(n)]}}function mc(e){return function(t,n){var i=mn(t*t+n*n),r=e(i),s=zt(r),o=qt(r);return[Qi(t*s,i*o),Gn(i&&n*s/i)]}}var Mb=bb(function(e){return mn(2/(1+e))});Mb.invert=mc(function(e){return 2*Gn(e/2)});function wb(){return Fr(Mb).scale(124.75).clipAngle(180-.001)}var Sb=bb(function(e){return(e=tb(e))&&e/zt(e)});Sb.invert=mc(function(e){return e});function Tb(){return Fr(Sb).scale(79.4188).clipAngle(180-.001)}function su(e,t){return[e,Xl(Gd((Ee+t)/2))]}su.invert=function(e,t){return[e,2*Uo(Qv(t))-Ee]};function Eb(){return Ab(su).scale(961/En)}function Ab(e){var t=Fr(e),n=t.center,i=t.scale,r=t.translate,s=t.clipExtent,o=null,a,c,l;t.scale=function(h){return arguments.length?(i(h),u()):i()},t.translate=function(h){return arguments.length?(r(h),u()):r()},t.center=function(h){return arguments.length?(n(h),u()):n()},t.clipExtent=function(h){return arguments.length?(h==null?o=a=c=l=null:(o=+h[0][0],a=+h[0][1],c=+h[1][0],l=+h[1][1]),u()):o==null?null:[[o,a],[c,l]]};function u(){var h=Zt*i(),f=t(SR(t.rotate()).invert([0,0]));return s(o==null?[[f[0]-h,f[1]-h],[f[0]+h,f[1]+h]]:e===su?[[Math.max(f[0]-h,o),a],[Math.min(f[0]+h,c),l]]:[[o,Math.max(f[1]-h,a)],[c,Math.min(f[1]+h,l)]])}return u()}function Wl(e){return Gd((Ee+e)/2)}function tI(e,t){var n=qt(e),i=e===t?zt(e):Xl(n/qt(t))/Xl(Wl(t)/Wl(e)),r=n*wd(Wl(e),i)/i;if(!i)return su;function s(o,a){r>0?a<-Ee+kt&&(a=-Ee+kt):a>Ee-kt&&(a=Ee-kt);var c=r/wd(Wl(a),i);return[c*zt(i*o),r-c*qt(i*o)]}return s.invert=function(o,a){var c=r-a,l=Vn(i)*mn(o*o+c*c),u=Qi(o,oe(c))*Vn(c);return c*i<0&&(u-=Zt*Vn(o)*Vn(c)),[u/i,2*Uo(wd(r/l,1/i))-Ee]},s}function Cb(){return Yd(tI).scale(109.5).parallels([30,30])}function nu(e,t){return[e,t]}nu.invert=nu;function Rb(){return Fr(nu).scale(152.63)}function eI(e,t){var n=qt(e),i=e===t?zt(e):(n-qt(t))/(t-e),r=n/i+e;if(oe(i)<kt)return nu;function s(o,a){var c=r-a,l=i*o;return[c*zt(l),r-c*qt(l)]}return s.invert=function(o,a){var c=r-a,l=Qi(o,oe(c))*Vn(c);return c*i<0&&(l-=Zt*Vn(o)*Vn(c)),[l/i,r-Vn(i)*mn(o*o+c*c)]},s}function Ib(){return Yd(eI).scale(131.154).center([0,13.9389])}var oc=1.340264,ac=-.081106,cc=893e-6,lc=.003796,iu=mn(3)/2,nI=12;function Pb(e,t){var n=Gn(iu*zt(t)),i=n*n,r=i*i*i;return[e*qt(n)/(iu*(oc+3*ac*i+r*(7*cc+9*lc*i))),n*(oc+ac*i+r*(cc+lc*i))]}Pb.invert=function(e,t){for(var n=t,i=n*n,r=i*i*i,s=0,o,a,c;s<nI&&(a=n*(oc+ac*i+r*(cc+lc*i))-t,c=oc+3*ac*i+r*(7*cc+9*lc*i),n-=o=a/c,i=n*n,r=i*i*i,!(oe(o)<jv));++s);return[iu*e*(oc+3*ac*i+r*(7*cc+9*lc*i))/qt(n),Gn(zt(n)/iu)]};function Lb(){return Fr(Pb).scale(177.158)}function Nb(e,t){var n=qt(t),i=qt(e)*n;return[n*zt(e)/i,zt(t)/i]}Nb.invert=mc(Uo);function Db(){return Fr(Nb).scale(144.049).clipAngle(60)}function iI(e,t){var n=t*t,i=n*n;return[e*(.8707-.131979*n+i*(-.013791+i*(.003971*n-.001529*i))),t*(1.007226+n*(.015085+i*(-.044475+.028874*n-.005916*i)))]}iI.invert=function(e,t){var n=t,i=25,r;do{var s=n*n,o=s*s;n-=r=(n*(1.007226+s*(.015085+o*(-.044475+.028874*s-.005916*o)))-t)/(1.007226+s*(.015085*3+o*(-.044475*7+.028874*9*s-.005916*11*o)))}while(oe(r)>kt&&--i>0);return[e/(.8707+(s=n*n)*(-.131979+s*(-.013791+s*s*s*(.003971-.001529*s)))),n]};function Ub(e,t){return[qt(t)*zt(e),zt(t)]}Ub.invert=mc(Gn);function Fb(){return Fr(Ub).scale(249.5).clipAngle(90+kt)}function Ob(e,t){var n=qt(t),i=1+qt(e)*n;return[n*zt(e)/i,zt(t)/i]}Ob.invert=mc(function(e){return 2*Uo(e)});function Bb(){return Fr(Ob).scale(250).clipAngle(142)}function kb(e,t){return[Xl(Gd((Ee+t)/2)),-e]}kb.invert=function(e,t){return[-t,2*Uo(Qv(e))-Ee]};function zb(){var e=Ab(kb),t=e.center,n=e.rotate;return e.center=function(i){return arguments.length?t([-i[1],i[0]]):(i=t(),[i[1],-i[0]])},e.rotate=function(i){return arguments.length?n([i[0],i[1],i.length>2?i[2]+90:90]):(i=n(),[i[0],i[1],i[2]-90])},n([0,0,90]).scale(159.155)}var Zd=new Date,Jd=new Date;function Be(e,t,n,i){function r(s){return e(s=arguments.length===0?new Date:new Date(+s)),s}return r.floor=s=>(e(s=new Date(+s)),s),r.ceil=s=>(e(s=new Date(s-1)),t(s,1),e(s),s),r.round=s=>{let o=r(s),a=r.ceil(s);return s-o<a-s?o:a},r.offset=(s,o)=>(t(s=new Date(+s),o==null?1:Math.floor(o)),s),r.range=(s,o,a)=>{let c=[];if(s=r.ceil(s),a=a==null?1:Math.floor(a),!(s<o)||!(a>0))return c;let l;do c.push(l=new Date(+s)),t(s,a),e(s);while(l<s&&s<o);return c},r.filter=s=>Be(o=>{if(o>=o)for(;e(o),!s(o);)o.setTime(o-1)},(o,a)=>{if(o>=o)if(a<0)for(;++a<=0;)for(;t(o,-1),!s(o););else for(;--a>=0;)for(;t(o,1),!s(o););}),n&&(r.count=(s,o)=>(Zd.setTime(+s),Jd.setTime(+o),e(Zd),e(Jd),Math.floor(n(Zd,Jd))),r.every=s=>(s=Math.floor(s),!isFinite(s)||!(s>0)?null:s>1?r.filter(i?o=>i(o)%s===0:o=>r.count(0,o)%s===0):r)),r}var ou=Be(()=>{},(e,t)=>{e.setTime(+e+t)},(e,t)=>t-e);ou.every=e=>(e=Math.floor(e),!isFinite(e)||!(e>0)?null:e>1?Be(t=>{t.setTime(Math.floor(t/e)*e)},(t,n)=>{t.setTime(+t+n*e)},(t,n)=>(n-t)/e):ou);var Dk=ou.range,tr=1e3,Wn=tr*60,er=Wn*60,nr=er*24,jd=nr*7,Vb=nr*30,Kd=nr*365,cn=Be(e=>{e.setTime(e-e.getMilliseconds())},(e,t)=>{e.setTime(+e+t*tr)},(e,t)=>(t-e)/tr,e=>e.getUTCSeconds()),Uk=cn.range,Ss=Be(e=>{e.setTime(e-e.getMilliseconds()-e.getSeconds()*tr)},(e,t)=>{e.setTime(+e+t*Wn)},(e,t)=>(t-e)/Wn,e=>e.getMinutes()),Fk=Ss.range,Ts=Be(e=>{e.setUTCSeconds(0,0)},(e,t)=>{e.setTime(+e+t*Wn)},(e,t)=>(t-e)/Wn,e=>e.getUTCMinutes()),Ok=Ts.range,Es=Be(e=>{e.setTime(e-e.getMilliseconds()-e.getSeconds()*tr-e.getMinutes()*Wn)},(e,t)=>{e.setTime(+e+t*er)},(e,t)=>(t-e)/er,e=>e.getHours()),Bk=Es.range,As=Be(e=>{e.setUTCMinutes(0,0,0)},(e,t)=>{e.setTime(+e+t*er)},(e,t)=>(t-e)/er,e=>e.getUTCHours()),kk=As.range,Ri=Be(e=>e.setHours(0,0,0,0),(e,t)=>e.setDate(e.getDate()+t),(e,t)=>(t-e-(t.getTimezoneOffset()-e.getTimezoneOffset())*Wn)/nr,e=>e.getDate()-1),zk=Ri.range,Fo=Be(e=>{e.setUTCHours(0,0,0,0)},(e,t)=>{e.setUTCDate(e.getUTCDate()+t)},(e,t)=>(t-e)/nr,e=>e.getUTCDate()-1),Vk=Fo.range,gc=Be(e=>{e.setUTCHours(0,0,0,0)},(e,t)=>{e.setUTCDate(e.getUTCDate()+t)},(e,t)=>(t-e)/nr,e=>Math.floor(e/nr)),Hk=gc.range;function Cs(e){return Be(t=>{t.setDate(t.getDate()-(t.getDay()+7-e)%7),t.setHours(0,0,0,0)},(t,n)=>{t.setDate(t.getDate()+n*7)},(t,n)=>(n-t-(n.getTimezoneOffset()-t.getTimezoneOffset())*Wn)/jd)}var Ii=Cs(0),Rs=Cs(1),Qd=Cs(2),tp=Cs(3),ir=Cs(4),ep=Cs(5),np=Cs(6),Gk=Ii.range,Wk=Rs.range,$k=Qd.range,Xk=tp.range,Yk=ir.range,qk=ep.range,Zk=np.range;function Is(e){return Be(t=>{t.setUTCDate(t.getUTCDate()-(t.getUTCDay()+7-e)%7),t.setUTCHours(0,0,0,0)},(t,n)=>{t.setUTCDate(t.getUTCDate()+n*7)},(t,n)=>(n-t)/jd)}var Pi=Is(0),Ps=Is(1),ip=Is(2),rp=Is(3),rr=Is(4),sp=Is(5),op=Is(6),Jk=Pi.range,Kk=Ps.range,jk=ip.range,Qk=rp.range,t8=rr.range,e8=sp.range,n8=op.range,Ls=Be(e=>{e.setDate(1),e.setHours(0,0,0,0)},(e,t)=>{e.setMonth(e.getMonth()+t)},(e,t)=>t.getMonth()-e.getMonth()+(t.getFullYear()-e.getFullYear())*12,e=>e.getMonth()),i8=Ls.range,Ns=Be(e=>{e.setUTCDate(1),e.setUTCHours(0,0,0,0)},(e,t)=>{e.setUTCMonth(e.getUTCMonth()+t)},(e,t)=>t.getUTCMonth()-e.getUTCMonth()+(t.getUTCFullYear()-e.getUTCFullYear())*12,e=>e.getUTCMonth()),r8=Ns.range,gn=Be(e=>{e.setMonth(0,1),e.setHours(0,0,0,0)},(e,t)=>{e.setFullYear(e.getFullYear()+t)},(e,t)=>t.getFullYear()-e.getFullYear(),e=>e.getFullYear());gn.every=e=>!isFinite(e=Math.floor(e))||!(e>0)?null:Be(t=>{t.setFullYear(Math.floor(t.getFullYear()/e)*e),t.setMonth(0,1),t.setHours(0,0,0,0)},(t,n)=>{t.setFullYear(t.getFullYear()+n*e)});var s8=gn.range,yn=Be(e=>{e.setUTCMonth(0,1),e.setUTCHours(0,0,0,0)},(e,t)=>{e.setUTCFullYear(e.getUTCFullYear()+t)},(e,t)=>t.getUTCFullYear()-e.getUTCFullYear(),e=>e.getUTCFullYear());yn.every=e=>!isFinite(e=Math.floor(e))||!(e>0)?null:Be(t=>{t.setUTCFullYear(Math.floor(t.getUTCFullYear()/e)*e),t.setUTCMonth(0,1),t.setUTCHours(0,0,0,0)},(t,n)=>{t.setUTCFullYear(t.getUTCFullYear()+n*e)});var o8=yn.range;function Hb(e,t,n,i,r,s){let o=[[cn,1,tr],[cn,5,5*tr],[cn,15,15*tr],[cn,30,30*tr],[s,1,Wn],[s,5,5*Wn],[s,15,15*Wn],[s,30,30*Wn],[r,1,er],[r,3,3*er],[r,6,6*er],[r,12,12*er],[i,1,nr],[i,2,2*nr],[n,1,jd],[t,1,Vb],[t,3,3*Vb],[e,1,Kd]];function a(l,u,h){let f=u<l;f&&([l,u]=[u,l]);let d=h&&typeof h.range=="function"?h:c(l,u,h),m=d?d.range(l,+u+1):[];return f?m.reverse():m}function c(l,u,h){let f=Math.abs(u-l)/h,d=_o(([,,g])=>g).right(o,f);if(d===o.length)return e.every(qa(l/Kd,u/Kd,h));if(d===0)return ou.every(Math.max(qa(l,u,h),1));let[m,y]=o[f/o[d-1][2]<o[d][2]/f?d-1:d];return m.every(y)}return[a,c]}var[Gb,au]=Hb(yn,Ns,Pi,gc,As,Ts),[Wb,$b]=Hb(gn,Ls,Ii,Ri,Es,Ss);function ap(e){if(0<=e.y&&e.y<100){var t=new Date(-1,e.m,e.d,e.H,e.M,e.S,e.L);return t.setFullYear(e.y),t}return new Date(e.y,e.m,e.d,e.H,e.M,e.S,e.L)}function cp(e){if(0<=e.y&&e.y<100){var t=new Date(Date.UTC(-1,e.m,e.d,e.H,e.M,e.S,e.L));return t.setUTCFullYear(e.y),t}return new Date(Date.UTC(e.y,e.m,e.d,e.H,e.M,e.S,e.L))}function yc(e,t,n){return{y:e,m:t,d:n,H:0,M:0,S:0,L:0}}function rI(e){var t=e.dateTime,n=e.date,i=e.time,r=e.periods,s=e.days,o=e.shortDays,a=e.months,c=e.shortMonths,l=xc(r),u=_c(r),h=xc(s),f=_c(s),d=xc(o),m=_c(o),y=xc(a),g=_c(a),p=xc(c),_=_c(c),b={a:H,A:z,b:G,B:j,c:null,d:Kb,e:Kb,f:AI,g:OI,G:kI,H:SI,I:TI,j:EI,L:n1,m:CI,M:RI,p:nt,q:ct,Q:t1,s:e1,S:II,u:PI,U:LI,V:NI,w:DI,W:UI,x:null,X:null,y:FI,Y:BI,Z:zI,"%":Qb},x={a:ft,A:$,b:tt,B:lt,c:null,d:jb,e:jb,f:WI,g:tP,G:nP,H:VI,I:HI,j:GI,L:r1,m:$I,M:XI,p:K,q:ut,Q:t1,s:e1,S:YI,u:qI,U:ZI,V:JI,w:KI,W:jI,x:null,X:null,y:QI,Y:eP,Z:iP,"%":Qb},C={a:v,A:E,b:N,B:U,c:F,d:Zb,e:Zb,f:vI,g:qb,G:Yb,H:Jb,I:Jb,j:gI,L:_I,m:mI,M:yI,p:M,q:pI,Q:MI,s:wI,S:xI,u:lI,U:uI,V:fI,w:cI,W:hI,x:P,X:O,y:qb,Y:Yb,Z:dI,"%":bI};b.x=w(n,b),b.X=w(i,b),b.c=w(t,b),x.x=w(n,x),x.X=w(i,x),x.c=w(t,x);function w(q,ot){return function(pt){var X=[],Lt=-1,L=0,Ot=q.length,St,Ut,Tt;for(pt instanceof Date||(pt=new Date(+pt));++Lt<Ot;)q.charCodeAt(Lt)===37&&(X.push(q.slice(L,Lt)),(Ut=Xb[St=q.charAt(++Lt)])!=null?St=q.charAt(++Lt):Ut=St==="e"?" ":"0",(Tt=ot[St])&&(St=Tt(pt,Ut)),X.push(St),L=Lt+1);return X.push(q.slice(L,Lt)),X.join("")}}function S(q,ot){return function(pt){var X=yc(1900,void 0,1),Lt=R(X,q,pt+="",0),L,Ot;if(Lt!=pt.length)return null;if("Q"in X)return new Date(X.Q);if("s"in X)return new Date(X.s*1e3+("L"in X?X.L:0));if(ot&&!("Z"in X)&&(X.Z=0),"p"in X&&(X.H=X.H%12+X.p*12),X.m===void 0&&(X.m="q"in X?X.q:0),"V"in X){if(X.V<1||X.V>53)return null;"w"in X||(X.w=1),"Z"in X?(L=cp(yc(X.y,0,1)),Ot=L.getUTCDay(),L=Ot>4||Ot===0?Ps.ceil(L):Ps(L),L=Fo.offset(L,(X.V-1)*7),X.y=L.getUTCFullYear(),X.m=L.getUTCMonth(),X.d=L.getUTCDate()+(X.w+6)%7):(L=ap(yc(X.y,0,1)),Ot=L.getDay(),L=Ot>4||Ot===0?Rs.ceil(L):Rs(L),L=Ri.offset(L,(X.V-1)*7),X.y=L.getFullYear(),X.m=L.getMonth(),X.d=L.getDate()+(X.w+6)%7)}else("W"in X||"U"in X)&&("w"in X||(X.w="u"in X?X.u%7:"W"in X?1:0),Ot="Z"in X?cp(yc(X.y,0,1)).getUTCDay():ap(yc(X.y,0,1)).getDay(),X.m=0,X.d="W"in X?(X.w+6)%7+X.W*7-(Ot+5)%7:X.w+X.U*7-(Ot+6)%7);return"Z"in X?(X.H+=X.Z/100|0,X.M+=X.Z%100,cp(X)):ap(X)}}function R(q,ot,pt,X){for(var Lt=0,L=ot.length,Ot=pt.length,St,Ut;Lt<L;){if(X>=Ot)return-1;if(St=ot.charCodeAt(Lt++),St===37){if(St=ot.charAt(Lt++),Ut=C[St in Xb?ot.charAt(Lt++):St],!Ut||(X=Ut(q,pt,X))<0)return-1}else if(St!=pt.charCodeAt(X++))return-1}return X}function M(q,ot,pt){var X=l.exec(ot.slice(pt));return X?(q.p=u.get(X[0].toLowerCase()),pt+X[0].length):-1}function v(q,ot,pt){var X=d.exec(ot.slice(pt));return X?(q.w=m.get(X[0].toLowerCase()),pt+X[0].length):-1}function E(q,ot,pt){var X=h.exec(ot.slice(pt));return X?(q.w=f.get(X[0].toLowerCase()),pt+X[0].length):-1}function N(q,ot,pt){var X=p.exec(ot.slice(pt));return X?(q.m=_.get(X[0].toLowerCase()),pt+X[0].length):-1}function U(q,ot,pt){var X=y.exec(ot.slice(pt));return X?(q.m=g.get(X[0].toLowerCase()),pt+X[0].length):-1}function F(q,ot,pt){return R(q,t,ot,pt)}function P(q,ot,pt){return R(q,n,ot,pt)}function O(q,ot,pt){return R(q,i,ot,pt)}function H(q){return o[q.getDay()]}function z(q){return s[q.getDay()]}function G(q){return c[q.getMonth()]}function j(q){return a[q.getMonth()]}function nt(q){return r[+(q.getHours()>=12)]}function ct(q){return 1+~~(q.getMonth()/3)}function ft(q){return o[q.getUTCDay()]}function $(q){return s[q.getUTCDay()]}function tt(q){return c[q.getUTCMonth()]}function lt(q){return a[q.getUTCMonth()]}function K(q){return r[+(q.getUTCHours()>=12)]}function ut(q){return 1+~~(q.getUTCMonth()/3)}return{format:function(q){var ot=w(q+="",b);return ot.toString=function(){return q},ot},parse:function(q){var ot=S(q+="",!1);return ot.toString=function(){return q},ot},utcFormat:function(q){var ot=w(q+="",x);return ot.toString=function(){return q},ot},utcParse:function(q){var ot=S(q+="",!0);return ot.toString=function(){return q},ot}}}var Xb={"-":"",_:" ",0:"0"},We=/^\s*\d+/,sI=/^%/,oI=/[\\^$*+?|[\]().{}]/g;function ie(e,t,n){var i=e<0?"-":"",r=(i?-e:e)+"",s=r.length;return i+(s<n?new Array(n-s+1).join(t)+r:r)}function aI(e){return e.replace(oI,"\\$&")}function xc(e){return new RegExp("^(?:"+e.map(aI).join("|")+")","i")}function _c(e){return new Map(e.map((t,n)=>[t.toLowerCase(),n]))}function cI(e,t,n){var i=We.exec(t.slice(n,n+1));return i?(e.w=+i[0],n+i[0].length):-1}function lI(e,t,n){var i=We.exec(t.slice(n,n+1));return i?(e.u=+i[0],n+i[0].length):-1}function uI(e,t,n){var i=We.exec(t.slice(n,n+2));return i?(e.U=+i[0],n+i[0].length):-1}function fI(e,t,n){var i=We.exec(t.slice(n,n+2));return i?(e.V=+i[0],n+i[0].length):-1}function hI(e,t,n){var i=We.exec(t.slice(n,n+2));return i?(e.W=+i[0],n+i[0].length):-1}function Yb(e,t,n){var i=We.exec(t.slice(n,n+4));return i?(e.y=+i[0],n+i[0].length):-1}function qb(e,t,n){var i=We.exec(t.slice(n,n+2));return i?(e.y=+i[0]+(+i[0]>68?1900:2e3),n+i[0].length):-1}function dI(e,t,n){var i=/^(Z)|([+-]\d\d)(?::?(\d\d))?/.exec(t.slice(n,n+6));return i?(e.Z=i[1]?0:-(i[2]+(i[3]||"00")),n+i[0].length):-1}function pI(e,t,n){var i=We.exec(t.slice(n,n+1));return i?(e.q=i[0]*3-3,n+i[0].length):-1}function mI(e,t,n){var i=We.exec(t.slice(n,n+2));return i?(e.m=i[0]-1,n+i[0].length):-1}function Zb(e,t,n){var i=We.exec(t.slice(n,n+2));return i?(e.d=+i[0],n+i[0].length):-1}function gI(e,t,n){var i=We.exec(t.slice(n,n+3));return i?(e.m=0,e.d=+i[0],n+i[0].length):-1}function Jb(e,t,n){var i=We.exec(t.slice(n,n+2));return i?(e.H=+i[0],n+i[0].length):-1}function yI(e,t,n){var i=We.exec(t.slice(n,n+2));return i?(e.M=+i[0],n+i[0].length):-1}function xI(e,t,n){var i=We.exec(t.slice(n,n+2));return i?(e.S=+i[0],n+i[0].length):-1}function _I(e,t,n){var i=We.exec(t.slice(n,n+3));return i?(e.L=+i[0],n+i[0].length):-1}function vI(e,t,n){var i=We.exec(t.slice(n,n+6));return i?(e.L=Math.floor(i[0]/1e3),n+i[0].length):-1}function bI(e,t,n){var i=sI.exec(t.slice(n,n+1));return i?n+i[0].length:-1}function MI(e,t,n){var i=We.exec(t.slice(n));return i?(e.Q=+i[0],n+i[0].length):-1}function wI(e,t,n){var i=We.exec(t.slice(n));return i?(e.s=+i[0],n+i[0].length):-1}function Kb(e,t){return ie(e.getDate(),t,2)}function SI(e,t){return ie(e.getHours(),t,2)}function TI(e,t){return ie(e.getHours()%12||12,t,2)}function EI(e,t){return ie(1+Ri.count(gn(e),e),t,3)}function n1(e,t){return ie(e.getMilliseconds(),t,3)}function AI(e,t){return n1(e,t)+"000"}function CI(e,t){return ie(e.getMonth()+1,t,2)}function RI(e,t){return ie(e.getMinutes(),t,2)}function II(e,t){return ie(e.getSeconds(),t,2)}function PI(e){var t=e.getDay();return t===0?7:t}function LI(e,t){return ie(Ii.count(gn(e)-1,e),t,2)}function i1(e){var t=e.getDay();return t>=4||t===0?ir(e):ir.ceil(e)}function NI(e,t){return e=i1(e),ie(ir.count(gn(e),e)+(gn(e).getDay()===4),t,2)}function DI(e){return e.getDay()}function UI(e,t){return ie(Rs.count(gn(e)-1,e),t,2)}function FI(e,t){return ie(e.getFullYear()%100,t,2)}function OI(e,t){return e=i1(e),ie(e.getFullYear()%100,t,2)}function BI(e,t){return ie(e.getFullYear()%1e4,t,4)}function kI(e,t){var n=e.getDay();return e=n>=4||n===0?ir(e):ir.ceil(e),ie(e.getFullYear()%1e4,t,4)}function zI(e){var t=e.getTimezoneOffset();return(t>0?"-":(t*=-1,"+"))+ie(t/60|0,"0",2)+ie(t%60,"0",2)}function jb(e,t){return ie(e.getUTCDate(),t,2)}function VI(e,t){return ie(e.getUTCHours(),t,2)}function HI(e,t){return ie(e.getUTCHours()%12||12,t,2)}function GI(e,t){return ie(1+Fo.count(yn(e),e),t,3)}function r1(e,t){return ie(e.getUTCMilliseconds(),t,3)}function WI(e,t){return r1(e,t)+"000"}function $I(e,t){return ie(e.getUTCMonth()+1,t,2)}function XI(e,t){return ie(e.getUTCMinutes(),t,2)}function YI(e,t){return ie(e.getUTCSeconds(),t,2)}function qI(e){var t=e.getUTCDay();return t===0?7:t}function ZI(e,t){return ie(Pi.count(yn(e)-1,e),t,2)}function s1(e){var t=e.getUTCDay();return t>=4||t===0?rr(e):rr.ceil(e)}function JI(e,t){return e=s1(e),ie(rr.count(yn(e),e)+(yn(e).getUTCDay()===4),t,2)}function KI(e){return e.getUTCDay()}function jI(e,t){return ie(Ps.count(yn(e)-1,e),t,2)}function QI(e,t){return ie(e.getUTCFullYear()%100,t,2)}function tP(e,t){return e=s1(e),ie(e.getUTCFullYear()%100,t,2)}function eP(e,t){return ie(e.getUTCFullYear()%1e4,t,4)}function nP(e,t){var n=e.getUTCDay();return e=n>=4||n===0?rr(e):rr.ceil(e),ie(e.getUTCFullYear()%1e4,t,4)}function iP(){return"+0000"}function Qb(){return"%"}function t1(e){return+e}function e1(e){return Math.floor(+e/1e3)}var Oo,vc,rP,Li,o1;sP({dateTime:"%x, %X",date:"%-m/%-d/%Y",time:"%-I:%M:%S %p",periods:["AM","PM"],days:["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"],shortDays:["Sun","Mon","Tue","Wed","Thu","Fri","Sat"],months:["January","February","March","April","May","June","July","August","September","October","November","December"],shortMonths:["Jan","Feb","Mar","Apr","May","Jun","Jul","Aug","Sep","Oct","Nov","Dec"]});function sP(e){return Oo=rI(e),vc=Oo.format,rP=Oo.parse,Li=Oo.utcFormat,o1=Oo.utcParse,Oo}var a1="%Y-%m-%dT%H:%M:%S.%LZ";function oP(e){return e.toISOString()}var l8=Date.prototype.toISOString?oP:Li(a1);function aP(e){var t=new Date(e);return isNaN(t)?null:t}var u8=+new Date("2000-01-01T00:00:00.000Z")?aP:o1(a1);function Ni(e,t){switch(arguments.length){case 0:break;case 1:this.range(e);break;default:this.range(t).domain(e);break}return this}function lu(e,t){switch(arguments.length){case 0:break;case 1:{typeof e=="function"?this.interpolator(e):this.range(e);break}default:{this.domain(e),typeof t=="function"?this.interpolator(t):this.range(t);break}}return this}var cu=Symbol("implicit");function uu(){var e=new On,t=[],n=[],i=cu;function r(s){let o=e.get(s);if(o===void 0){if(i!==cu)return i;e.set(s,o=t.push(s)-1)}return n[o%n.length]}return r.domain=function(s){if(!arguments.length)return t.slice();t=[],e=new On;for(let o of s)e.has(o)||e.set(o,t.push(o)-1);return r},r.range=function(s){return arguments.length?(n=Array.from(s),r):n.slice()},r.unknown=function(s){return arguments.length?(i=s,r):i},r.copy=function(){return uu(t,n).unknown(i)},Ni.apply(r,arguments),r}function Bo(){var e=uu().unknown(void 0),t=e.domain,n=e.range,i=0,r=1,s,o,a=!1,c=0,l=0,u=.5;delete e.unknown;function h(){var f=t().length,d=r<i,m=d?r:i,y=d?i:r;s=(y-m)/Math.max(1,f-c+l*2),a&&(s=Math.floor(s)),m+=(y-m-s*(f-c))*u,o=s*(1-c),a&&(m=Math.round(m),o=Math.round(o));var g=bo(f).map(function(p){return m+s*p});return n(d?g.reverse():g)}return e.domain=function(f){return arguments.length?(t(f),h()):t()},e.range=function(f){return arguments.length?([i,r]=f,i=+i,r=+r,h()):[i,r]},e.rangeRound=function(f){return[i,r]=f,i=+i,r=+r,a=!0,h()},e.bandwidth=function(){return o},e.step=function(){return s},e.round=function(f){return arguments.length?(a=!!f,h()):a},e.padding=function(f){return arguments.length?(c=Math.min(1,l=+f),h()):c},e.paddingInner=function(f){return arguments.length?(c=Math.min(1,f),h()):c},e.paddingOuter=function(f){return arguments.length?(l=+f,h()):l},e.align=function(f){return arguments.length?(u=Math.max(0,Math.min(1,f)),h()):u},e.copy=function(){return Bo(t(),[i,r]).round(a).paddingInner(c).paddingOuter(l).align(u)},Ni.apply(h(),arguments)}function m1(e){var t=e.copy;return e.padding=e.paddingOuter,delete e.paddingInner,delete e.paddingOuter,e.copy=function(){return m1(t())},e}function g1(){return m1(Bo.apply(null,arguments).paddingInner(1))}function cP(e){return function(){return e}}function lp(e){return+e}var c1=[0,1];function $n(e){return e}function up(e,t){return(t-=e=+e)?function(n){return(n-e)/t}:cP(isNaN(t)?NaN:.5)}function lP(e,t){var n;return e>t&&(n=e,e=t,t=n),function(i){return Math.max(e,Math.min(t,i))}}function uP(e,t,n){var i=e[0],r=e[1],s=t[0],o=t[1];return r<i?(i=up(r,i),s=n(o,s)):(i=up(i,r),s=n(s,o)),function(a){return s(i(a))}}function fP(e,t,n){var i=Math.min(e.length,t.length)-1,r=new Array(i),s=new Array(i),o=-1;for(e[i]<e[0]&&(e=e.slice().reverse(),t=t.slice().reverse());++o<i;)r[o]=up(e[o],e[o+1]),s[o]=n(t[o],t[o+1]);return function(a){var c=vo(e,a,1,i)-1;return s[c](r[c](a))}}function bc(e,t){return t.domain(e.domain()).range(e.range()).interpolate(e.interpolate()).clamp(e.clamp()).unknown(e.unknown())}function fu(){var e=c1,t=c1,n=Ro,i,r,s,o=$n,a,c,l;function u(){var f=Math.min(e.length,t.length);return o!==$n&&(o=lP(e[0],e[f-1])),a=f>2?fP:uP,c=l=null,h}function h(f){return f==null||isNaN(f=+f)?s:(c||(c=a(e.map(i),t,n)))(i(o(f)))}return h.invert=function(f){return o(r((l||(l=a(t,e.map(i),Oe)))(f)))},h.domain=function(f){return arguments.length?(e=Array.from(f,lp),u()):e.slice()},h.range=function(f){return arguments.length?(t=Array.from(f),u()):t.slice()},h.rangeRound=function(f){return t=Array.from(f),n=Qa,u()},h.clamp=function(f){return arguments.length?(o=f?!0:$n,u()):o!==$n},h.interpolate=function(f){return arguments.length?(n=f,u()):n},h.unknown=function(f){return arguments.length?(s=f,h):s},function(f,d){return i=f,r=d,u()}}function y1(){return fu()($n,$n)}function hP(e,t,n,i){var r=qa(e,t,n),s;switch(i=Po(i??",f"),i.type){case"s":{var o=Math.max(Math.abs(e),Math.abs(t));return i.precision==null&&!isNaN(s=Lv(r,o))&&(i.precision=s),Md(i,o)}case"":case"e":case"g":case"p":case"r":{i.precision==null&&!isNaN(s=Nv(r,Math.max(Math.abs(e),Math.abs(t))))&&(i.precision=s-(i.type==="e"));break}case"f":case"%":{i.precision==null&&!isNaN(s=Pv(r))&&(i.precision=s-(i.type==="%")*2);break}}return Ei(i)}function Mc(e){var t=e.domain;return e.ticks=function(n){var i=t();return Pr(i[0],i[i.length-1],n??10)},e.tickFormat=function(n,i){var r=t();return hP(r[0],r[r.length-1],n??10,i)},e.nice=function(n){n==null&&(n=10);var i=t(),r=0,s=i.length-1,o=i[r],a=i[s],c,l,u=10;for(a<o&&(l=o,o=a,a=l,l=r,r=s,s=l);u-- >0;){if(l=xo(o,a,n),l===c)return i[r]=o,i[s]=a,t(i);if(l>0)o=Math.floor(o/l)*l,a=Math.ceil(a/l)*l;else if(l<0)o=Math.ceil(o*l)/l,a=Math.floor(a*l)/l;else break;c=l}return e},e}function wc(){var e=y1();return e.copy=function(){return bc(e,wc())},Ni.apply(e,arguments),Mc(e)}function fp(e){var t;function n(i){return i==null||isNaN(i=+i)?t:i}return n.invert=n,n.domain=n.range=function(i){return arguments.length?(e=Array.from(i,lp),n):e.slice()},n.unknown=function(i){return arguments.length?(t=i,n):t},n.copy=function(){return fp(e).unknown(t)},e=arguments.length?Array.from(e,lp):[0,1],Mc(n)}function x1(e,t){e=e.slice();var n=0,i=e.length-1,r=e[n],s=e[i],o;return s<r&&(o=n,n=i,i=o,o=r,r=s,s=o),e[n]=t.floor(r),e[i]=t.ceil(s),e}function l1(e){return Math.log(e)}function u1(e){return Math.exp(e)}function dP(e){return-Math.log(-e)}function pP(e){return-Math.exp(-e)}function mP(e){return isFinite(e)?+("1e"+e):e<0?0:e}function gP(e){return e===10?mP:e===Math.E?Math.exp:t=>Math.pow(e,t)}function yP(e){return e===Math.E?Math.log:e===10&&Math.log10||e===2&&Math.log2||(e=Math.log(e),t=>Math.log(t)/e)}function f1(e){return(t,n)=>-e(-t,n)}function _1(e){let t=e(l1,u1),n=t.domain,i=10,r,s;function o(){return r=yP(i),s=gP(i),n()[0]<0?(r=f1(r),s=f1(s),e(dP,pP)):e(l1,u1),t}return t.base=function(a){return arguments.length?(i=+a,o()):i},t.domain=function(a){return arguments.length?(n(a),o()):n()},t.ticks=a=>{let c=n(),l=c[0],u=c[c.length-1],h=u<l;h&&([l,u]=[u,l]);let f=r(l),d=r(u),m,y,g=a==null?10:+a,p=[];if(!(i%1)&&d-f<g){if(f=Math.floor(f),d=Math.ceil(d),l>0){for(;f<=d;++f)for(m=1;m<i;++m)if(y=f<0?m/s(-f):m*s(f),!(y<l)){if(y>u)break;p.push(y)}}else for(;f<=d;++f)for(m=i-1;m>=1;--m)if(y=f>0?m/s(-f):m*s(f),!(y<l)){if(y>u)break;p.push(y)}p.length*2<g&&(p=Pr(l,u,g))}else p=Pr(f,d,Math.min(d-f,g)).map(s);return h?p.reverse():p},t.tickFormat=(a,c)=>{if(a==null&&(a=10),c==null&&(c=i===10?"s":","),typeof c!="function"&&(!(i%1)&&(c=Po(c)).precision==null&&(c.trim=!0),c=Ei(c)),a===1/0)return c;let l=Math.max(1,i*a/t.ticks().length);return u=>{let h=u/s(Math.round(r(u)));return h*i<i-.5&&(h*=i),h<=l?c(u):""}},t.nice=()=>n(x1(n(),{floor:a=>s(Math.floor(r(a))),ceil:a=>s(Math.ceil(r(a)))})),t}function hp(){let e=_1(fu()).domain([1,10]);return e.copy=()=>bc(e,hp()).base(e.base()),Ni.apply(e,arguments),e}function h1(e){return function(t){return Math.sign(t)*Math.log1p(Math.abs(t/e))}}function d1(e){return function(t){return Math.sign(t)*Math.expm1(Math.abs(t))*e}}function v1(e){var t=1,n=e(h1(t),d1(t));return n.constant=function(i){return arguments.length?e(h1(t=+i),d1(t)):t},Mc(n)}function dp(){var e=v1(fu());return e.copy=function(){return bc(e,dp()).constant(e.constant())},Ni.apply(e,arguments)}function p1(e){return function(t){return t<0?-Math.pow(-t,e):Math.pow(t,e)}}function xP(e){return e<0?-Math.sqrt(-e):Math.sqrt(e)}function _P(e){return e<0?-e*e:e*e}function b1(e){var t=e($n,$n),n=1;function i(){return n===1?e($n,$n):n===.5?e(xP,_P):e(p1(n),p1(1/n))}return t.exponent=function(r){return arguments.length?(n=+r,i()):n},Mc(t)}function pp(){var e=b1(fu());return e.copy=function(){return bc(e,pp()).exponent(e.exponent())},Ni.apply(e,arguments),e}function mp(){var e=[],t=[],n=[],i;function r(){var o=0,a=Math.max(1,t.length);for(n=new Array(a-1);++o<a;)n[o-1]=w_(e,o/a);return s}function s(o){return o==null||isNaN(o=+o)?i:t[vo(n,o)]}return s.invertExtent=function(o){var a=t.indexOf(o);return a<0?[NaN,NaN]:[a>0?n[a-1]:e[0],a<n.length?n[a]:e[e.length-1]]},s.domain=function(o){if(!arguments.length)return e.slice();e=[];for(let a of o)a!=null&&!isNaN(a=+a)&&e.push(a);return e.sort(tn),r()},s.range=function(o){return arguments.length?(t=Array.from(o),r()):t.slice()},s.unknown=function(o){return arguments.length?(i=o,s):i},s.quantiles=function(){return n.slice()},s.copy=function(){return mp().domain(e).range(t).unknown(i)},Ni.apply(s,arguments)}function gp(){var e=[.5],t=[0,1],n,i=1;function r(s){return s!=null&&s<=s?t[vo(e,s,0,i)]:n}return r.domain=function(s){return arguments.length?(e=Array.from(s),i=Math.min(e.length,t.length-1),r):e.slice()},r.range=function(s){return arguments.length?(t=Array.from(s),i=Math.min(e.length,t.length-1),r):t.slice()},r.invertExtent=function(s){var o=t.indexOf(s);return[e[o-1],e[o]]},r.unknown=function(s){return arguments.length?(n=s,r):n},r.copy=function(){return gp().domain(e).range(t).unknown(n)},Ni.apply(r,arguments)}function vP(e){return new Date(e)}function bP(e){return e instanceof Date?+e:Math.round(e)}function yp(e,t,n,i,r,s,o,a,c,l){var u=y1(),h=u.invert,f=u.domain,d=l(".%L"),m=l(":%S"),y=l("%I:%M"),g=l("%I %p"),p=l("%a %d"),_=l("%b %d"),b=l("%B"),x=l("%Y");function C(w){return(c(w)<w?d:a(w)<w?m:o(w)<w?y:s(w)<w?g:i(w)<w?r(w)<w?p:_:n(w)<w?b:x)(w)}return u.invert=function(w){return new Date(Math.round(h(w)))},u.domain=function(w){return arguments.length?f(Array.from(w,bP)):f().map(vP)},u.ticks=function(w){var S=f();return e(S[0],S[S.length-1],w??10)},u.tickFormat=function(w,S){return S==null?C:l(S)},u.nice=function(w){var S=f();return(!w||typeof w.range!="function")&&(w=t(S[0],S[S.length-1],w??10)),w?f(x1(S,w)):u},u.copy=function(){return bc(u,yp(e,t,n,i,r,s,o,a,c,l))},u}function M1(){return Ni.apply(yp(Wb,$b,gn,Ls,Ii,Ri,Es,Ss,cn,vc).domain([new Date(2e3,0,1),new Date(2e3,0,2)]),arguments)}function w1(){return Ni.apply(yp(Gb,au,yn,Ns,Pi,Fo,As,Ts,cn,Li).domain([Date.UTC(2e3,0,1),Date.UTC(2e3,0,2)]),arguments)}function hu(e,t){return t.domain(e.domain()).interpolator(e.interpolator()).clamp(e.clamp()).unknown(e.unknown())}function du(){var e=0,t=.5,n=1,i=1,r,s,o,a,c,l=$n,u,h=!1,f;function d(y){return y==null||isNaN(y=+y)?f:(y=.5+((y=+u(y))-s)*(i*y<i*s?a:c),l(h?Math.max(0,Math.min(1,y)):y))}d.domain=function(y){return arguments.length?([e,t,n]=y,r=u(e=+e),s=u(t=+t),o=u(n=+n),a=r===s?0:.5/(s-r),c=s===o?0:.5/(o-s),i=s<r?-1:1,d):[e,t,n]},d.clamp=function(y){return arguments.length?(h=!!y,d):h},d.interpolator=function(y){return arguments.length?(l=y,d):l};function m(y){return function(g){var p,_,b;return arguments.length?([p,_,b]=g,l=Dr(y,[p,_,b]),d):[l(0),l(.5),l(1)]}}return d.range=m(Ro),d.rangeRound=m(Qa),d.unknown=function(y){return arguments.length?(f=y,d):f},function(y){return u=y,r=y(e),s=y(t),o=y(n),a=r===s?0:.5/(s-r),c=s===o?0:.5/(o-s),i=s<r?-1:1,d}}function xp(){var e=Mc(du()($n));return e.copy=function(){return hu(e,xp())},lu.apply(e,arguments)}function _p(){var e=_1(du()).domain([.1,1,10]);return e.copy=function(){return hu(e,_p()).base(e.base())},lu.apply(e,arguments)}function vp(){var e=v1(du());return e.copy=function(){return hu(e,vp()).constant(e.constant())},lu.apply(e,arguments)}function bp(){var e=b1(du());return e.copy=function(){return hu(e,bp()).exponent(e.exponent())},lu.apply(e,arguments)}function Vt(e){for(var t=e.length/6|0,n=new Array(t),i=0;i<t;)n[i]="#"+e.slice(i*6,++i*6);return n}var S1=Vt("1f77b4ff7f0e2ca02cd627289467bd8c564be377c27f7f7fbcbd2217becf"),T1=Vt("7fc97fbeaed4fdc086ffff99386cb0f0027fbf5b17666666"),E1=Vt("1b9e77d95f027570b3e7298a66a61ee6ab02a6761d666666"),A1=Vt("4269d0efb118ff725c6cc5b03ca951ff8ab7a463f297bbf59c6b4e9498a0"),C1=Vt("a6cee31f78b4b2df8a33a02cfb9a99e31a1cfdbf6fff7f00cab2d66a3d9affff99b15928"),R1=Vt("fbb4aeb3cde3ccebc5decbe4fed9a6ffffcce5d8bdfddaecf2f2f2"),I1=Vt("b3e2cdfdcdaccbd5e8f4cae4e6f5c9fff2aef1e2cccccccc"),P1=Vt("e41a1c377eb84daf4a984ea3ff7f00ffff33a65628f781bf999999"),L1=Vt("66c2a5fc8d628da0cbe78ac3a6d854ffd92fe5c494b3b3b3"),N1=Vt("8dd3c7ffffb3bebadafb807280b1d3fdb462b3de69fccde5d9d9d9bc80bdccebc5ffed6f"),D1=Vt("4e79a7f28e2ce1575976b7b259a14fedc949af7aa1ff9da79c755fbab0ab"),me=e=>mv(e[e.length-1]),Mp=new Array(3).concat("d8b365f5f5f55ab4ac","a6611adfc27d80cdc1018571","a6611adfc27df5f5f580cdc1018571","8c510ad8b365f6e8c3c7eae55ab4ac01665e","8c510ad8b365f6e8c3f5f5f5c7eae55ab4ac01665e","8c510abf812ddfc27df6e8c3c7eae580cdc135978f01665e","8c510abf812ddfc27df6e8c3f5f5f5c7eae580cdc135978f01665e","5430058c510abf812ddfc27df6e8c3c7eae580cdc135978f01665e003c30","5430058c510abf812ddfc27df6e8c3f5f5f5c7eae580cdc135978f01665e003c30").map(Vt),wp=me(Mp),Sp=new Array(3).concat("af8dc3f7f7f77fbf7b","7b3294c2a5cfa6dba0008837","7b3294c2a5cff7f7f7a6dba0008837","762a83af8dc3e7d4e8d9f0d37fbf7b1b7837","762a83af8dc3e7d4e8f7f7f7d9f0d37fbf7b1b7837","762a839970abc2a5cfe7d4e8d9f0d3a6dba05aae611b7837","762a839970abc2a5cfe7d4e8f7f7f7d9f0d3a6dba05aae611b7837","40004b762a839970abc2a5cfe7d4e8d9f0d3a6dba05aae611b783700441b","40004b762a839970abc2a5cfe7d4e8f7f7f7d9f0d3a6dba05aae611b783700441b").map(Vt),Tp=me(Sp),Ep=new Array(3).concat("e9a3c9f7f7f7a1d76a","d01c8bf1b6dab8e1864dac26","d01c8bf1b6daf7f7f7b8e1864dac26","c51b7de9a3c9fde0efe6f5d0a1d76a4d9221","c51b7de9a3c9fde0eff7f7f7e6f5d0a1d76a4d9221","c51b7dde77aef1b6dafde0efe6f5d0b8e1867fbc414d9221","c51b7dde77aef1b6dafde0eff7f7f7e6f5d0b8e1867fbc414d9221","8e0152c51b7dde77aef1b6dafde0efe6f5d0b8e1867fbc414d9221276419","8e0152c51b7dde77aef1b6dafde0eff7f7f7e6f5d0b8e1867fbc414d9221276419").map(Vt),Ap=me(Ep),Cp=new Array(3).concat("998ec3f7f7f7f1a340","5e3c99b2abd2fdb863e66101","5e3c99b2abd2f7f7f7fdb863e66101","542788998ec3d8daebfee0b6f1a340b35806","542788998ec3d8daebf7f7f7fee0b6f1a340b35806","5427888073acb2abd2d8daebfee0b6fdb863e08214b35806","5427888073acb2abd2d8daebf7f7f7fee0b6fdb863e08214b35806","2d004b5427888073acb2abd2d8daebfee0b6fdb863e08214b358067f3b08","2d004b5427888073acb2abd2d8daebf7f7f7fee0b6fdb863e08214b358067f3b08").map(Vt),Rp=me(Cp),gu=new Array(3).concat("ef8a62f7f7f767a9cf","ca0020f4a58292c5de0571b0","ca0020f4a582f7f7f792c5de0571b0","b2182bef8a62fddbc7d1e5f067a9cf2166ac","b2182bef8a62fddbc7f7f7f7d1e5f067a9cf2166ac","b2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac","b2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac","67001fb2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac053061","67001fb2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac053061").map(Vt),Sc=me(gu),Ip=new Array(3).concat("ef8a62ffffff999999","ca0020f4a582bababa404040","ca0020f4a582ffffffbababa404040","b2182bef8a62fddbc7e0e0e09999994d4d4d","b2182bef8a62fddbc7ffffffe0e0e09999994d4d4d","b2182bd6604df4a582fddbc7e0e0e0bababa8787874d4d4d","b2182bd6604df4a582fddbc7ffffffe0e0e0bababa8787874d4d4d","67001fb2182bd6604df4a582fddbc7e0e0e0bababa8787874d4d4d1a1a1a","67001fb2182bd6604df4a582fddbc7ffffffe0e0e0bababa8787874d4d4d1a1a1a").map(Vt),Pp=me(Ip),yu=new Array(3).concat("fc8d59ffffbf91bfdb","d7191cfdae61abd9e92c7bb6","d7191cfdae61ffffbfabd9e92c7bb6","d73027fc8d59fee090e0f3f891bfdb4575b4","d73027fc8d59fee090ffffbfe0f3f891bfdb4575b4","d73027f46d43fdae61fee090e0f3f8abd9e974add14575b4","d73027f46d43fdae61fee090ffffbfe0f3f8abd9e974add14575b4","a50026d73027f46d43fdae61fee090e0f3f8abd9e974add14575b4313695","a50026d73027f46d43fdae61fee090ffffbfe0f3f8abd9e974add14575b4313695").map(Vt),Tc=me(yu),Lp=new Array(3).concat("fc8d59ffffbf91cf60","d7191cfdae61a6d96a1a9641","d7191cfdae61ffffbfa6d96a1a9641","d73027fc8d59fee08bd9ef8b91cf601a9850","d73027fc8d59fee08bffffbfd9ef8b91cf601a9850","d73027f46d43fdae61fee08bd9ef8ba6d96a66bd631a9850","d73027f46d43fdae61fee08bffffbfd9ef8ba6d96a66bd631a9850","a50026d73027f46d43fdae61fee08bd9ef8ba6d96a66bd631a9850006837","a50026d73027f46d43fdae61fee08bffffbfd9ef8ba6d96a66bd631a9850006837").map(Vt),Np=me(Lp),Dp=new Array(3).concat("fc8d59ffffbf99d594","d7191cfdae61abdda42b83ba","d7191cfdae61ffffbfabdda42b83ba","d53e4ffc8d59fee08be6f59899d5943288bd","d53e4ffc8d59fee08bffffbfe6f59899d5943288bd","d53e4ff46d43fdae61fee08be6f598abdda466c2a53288bd","d53e4ff46d43fdae61fee08bffffbfe6f598abdda466c2a53288bd","9e0142d53e4ff46d43fdae61fee08be6f598abdda466c2a53288bd5e4fa2","9e0142d53e4ff46d43fdae61fee08bffffbfe6f598abdda466c2a53288bd5e4fa2").map(Vt),Up=me(Dp),Fp=new Array(3).concat("e5f5f999d8c92ca25f","edf8fbb2e2e266c2a4238b45","edf8fbb2e2e266c2a42ca25f006d2c","edf8fbccece699d8c966c2a42ca25f006d2c","edf8fbccece699d8c966c2a441ae76238b45005824","f7fcfde5f5f9ccece699d8c966c2a441ae76238b45005824","f7fcfde5f5f9ccece699d8c966c2a441ae76238b45006d2c00441b").map(Vt),Op=me(Fp),Bp=new Array(3).concat("e0ecf49ebcda8856a7","edf8fbb3cde38c96c688419d","edf8fbb3cde38c96c68856a7810f7c","edf8fbbfd3e69ebcda8c96c68856a7810f7c","edf8fbbfd3e69ebcda8c96c68c6bb188419d6e016b","f7fcfde0ecf4bfd3e69ebcda8c96c68c6bb188419d6e016b","f7fcfde0ecf4bfd3e69ebcda8c96c68c6bb188419d810f7c4d004b").map(Vt),kp=me(Bp),zp=new Array(3).concat("e0f3dba8ddb543a2ca","f0f9e8bae4bc7bccc42b8cbe","f0f9e8bae4bc7bccc443a2ca0868ac","f0f9e8ccebc5a8ddb57bccc443a2ca0868ac","f0f9e8ccebc5a8ddb57bccc44eb3d32b8cbe08589e","f7fcf0e0f3dbccebc5a8ddb57bccc44eb3d32b8cbe08589e","f7fcf0e0f3dbccebc5a8ddb57bccc44eb3d32b8cbe0868ac084081").map(Vt),Vp=me(zp),Hp=new Array(3).concat("fee8c8fdbb84e34a33","fef0d9fdcc8afc8d59d7301f","fef0d9fdcc8afc8d59e34a33b30000","fef0d9fdd49efdbb84fc8d59e34a33b30000","fef0d9fdd49efdbb84fc8d59ef6548d7301f990000","fff7ecfee8c8fdd49efdbb84fc8d59ef6548d7301f990000","fff7ecfee8c8fdd49efdbb84fc8d59ef6548d7301fb300007f0000").map(Vt),Gp=me(Hp),Wp=new Array(3).concat("ece2f0a6bddb1c9099","f6eff7bdc9e167a9cf02818a","f6eff7bdc9e167a9cf1c9099016c59","f6eff7d0d1e6a6bddb67a9cf1c9099016c59","f6eff7d0d1e6a6bddb67a9cf3690c002818a016450","fff7fbece2f0d0d1e6a6bddb67a9cf3690c002818a016450","fff7fbece2f0d0d1e6a6bddb67a9cf3690c002818a016c59014636").map(Vt),$p=me(Wp),Xp=new Array(3).concat("ece7f2a6bddb2b8cbe","f1eef6bdc9e174a9cf0570b0","f1eef6bdc9e174a9cf2b8cbe045a8d","f1eef6d0d1e6a6bddb74a9cf2b8cbe045a8d","f1eef6d0d1e6a6bddb74a9cf3690c00570b0034e7b","fff7fbece7f2d0d1e6a6bddb74a9cf3690c00570b0034e7b","fff7fbece7f2d0d1e6a6bddb74a9cf3690c00570b0045a8d023858").map(Vt),Yp=me(Xp),qp=new Array(3).concat("e7e1efc994c7dd1c77","f1eef6d7b5d8df65b0ce1256","f1eef6d7b5d8df65b0dd1c77980043","f1eef6d4b9dac994c7df65b0dd1c77980043","f1eef6d4b9dac994c7df65b0e7298ace125691003f","f7f4f9e7e1efd4b9dac994c7df65b0e7298ace125691003f","f7f4f9e7e1efd4b9dac994c7df65b0e7298ace125698004367001f").map(Vt),Zp=me(qp),Jp=new Array(3).concat("fde0ddfa9fb5c51b8a","feebe2fbb4b9f768a1ae017e","feebe2fbb4b9f768a1c51b8a7a0177","feebe2fcc5c0fa9fb5f768a1c51b8a7a0177","feebe2fcc5c0fa9fb5f768a1dd3497ae017e7a0177","fff7f3fde0ddfcc5c0fa9fb5f768a1dd3497ae017e7a0177","fff7f3fde0ddfcc5c0fa9fb5f768a1dd3497ae017e7a017749006a").map(Vt),Kp=me(Jp),jp=new Array(3).concat("edf8b17fcdbb2c7fb8","ffffcca1dab441b6c4225ea8","ffffcca1dab441b6c42c7fb8253494","ffffccc7e9b47fcdbb41b6c42c7fb8253494","ffffccc7e9b47fcdbb41b6c41d91c0225ea80c2c84","ffffd9edf8b1c7e9b47fcdbb41b6c41d91c0225ea80c2c84","ffffd9edf8b1c7e9b47fcdbb41b6c41d91c0225ea8253494081d58").map(Vt),Qp=me(jp),tm=new Array(3).concat("f7fcb9addd8e31a354","ffffccc2e69978c679238443","ffffccc2e69978c67931a354006837","ffffccd9f0a3addd8e78c67931a354006837","ffffccd9f0a3addd8e78c67941ab5d238443005a32","ffffe5f7fcb9d9f0a3addd8e78c67941ab5d238443005a32","ffffe5f7fcb9d9f0a3addd8e78c67941ab5d238443006837004529").map(Vt),em=me(tm),nm=new Array(3).concat("fff7bcfec44fd95f0e","ffffd4fed98efe9929cc4c02","ffffd4fed98efe9929d95f0e993404","ffffd4fee391fec44ffe9929d95f0e993404","ffffd4fee391fec44ffe9929ec7014cc4c028c2d04","ffffe5fff7bcfee391fec44ffe9929ec7014cc4c028c2d04","ffffe5fff7bcfee391fec44ffe9929ec7014cc4c02993404662506").map(Vt),im=me(nm),rm=new Array(3).concat("ffeda0feb24cf03b20","ffffb2fecc5cfd8d3ce31a1c","ffffb2fecc5cfd8d3cf03b20bd0026","ffffb2fed976feb24cfd8d3cf03b20bd0026","ffffb2fed976feb24cfd8d3cfc4e2ae31a1cb10026","ffffccffeda0fed976feb24cfd8d3cfc4e2ae31a1cb10026","ffffccffeda0fed976feb24cfd8d3cfc4e2ae31a1cbd0026800026").map(Vt),sm=me(rm),om=new Array(3).concat("deebf79ecae13182bd","eff3ffbdd7e76baed62171b5","eff3ffbdd7e76baed63182bd08519c","eff3ffc6dbef9ecae16baed63182bd08519c","eff3ffc6dbef9ecae16baed64292c62171b5084594","f7fbffdeebf7c6dbef9ecae16baed64292c62171b5084594","f7fbffdeebf7c6dbef9ecae16baed64292c62171b508519c08306b").map(Vt),am=me(om),cm=new Array(3).concat("e5f5e0a1d99b31a354","edf8e9bae4b374c476238b45","edf8e9bae4b374c47631a354006d2c","edf8e9c7e9c0a1d99b74c47631a354006d2c","edf8e9c7e9c0a1d99b74c47641ab5d238b45005a32","f7fcf5e5f5e0c7e9c0a1d99b74c47641ab5d238b45005a32","f7fcf5e5f5e0c7e9c0a1d99b74c47641ab5d238b45006d2c00441b").map(Vt),lm=me(cm),um=new Array(3).concat("f0f0f0bdbdbd636363","f7f7f7cccccc969696525252","f7f7f7cccccc969696636363252525","f7f7f7d9d9d9bdbdbd969696636363252525","f7f7f7d9d9d9bdbdbd969696737373525252252525","fffffff0f0f0d9d9d9bdbdbd969696737373525252252525","fffffff0f0f0d9d9d9bdbdbd969696737373525252252525000000").map(Vt),fm=me(um),hm=new Array(3).concat("efedf5bcbddc756bb1","f2f0f7cbc9e29e9ac86a51a3","f2f0f7cbc9e29e9ac8756bb154278f","f2f0f7dadaebbcbddc9e9ac8756bb154278f","f2f0f7dadaebbcbddc9e9ac8807dba6a51a34a1486","fcfbfdefedf5dadaebbcbddc9e9ac8807dba6a51a34a1486","fcfbfdefedf5dadaebbcbddc9e9ac8807dba6a51a354278f3f007d").map(Vt),dm=me(hm),pm=new Array(3).concat("fee0d2fc9272de2d26","fee5d9fcae91fb6a4acb181d","fee5d9fcae91fb6a4ade2d26a50f15","fee5d9fcbba1fc9272fb6a4ade2d26a50f15","fee5d9fcbba1fc9272fb6a4aef3b2ccb181d99000d","fff5f0fee0d2fcbba1fc9272fb6a4aef3b2ccb181d99000d","fff5f0fee0d2fcbba1fc9272fb6a4aef3b2ccb181da50f1567000d").map(Vt),mm=me(pm),gm=new Array(3).concat("fee6cefdae6be6550d","feeddefdbe85fd8d3cd94701","feeddefdbe85fd8d3ce6550da63603","feeddefdd0a2fdae6bfd8d3ce6550da63603","feeddefdd0a2fdae6bfd8d3cf16913d948018c2d04","fff5ebfee6cefdd0a2fdae6bfd8d3cf16913d948018c2d04","fff5ebfee6cefdd0a2fdae6bfd8d3cf16913d94801a636037f2704").map(Vt),ym=me(gm);function xm(e){return e=Math.max(0,Math.min(1,e)),"rgb("+Math.max(0,Math.min(255,Math.round(-4.54-e*(35.34-e*(2381.73-e*(6402.7-e*(7024.72-e*2710.57)))))))+", "+Math.max(0,Math.min(255,Math.round(32.49+e*(170.73+e*(52.82-e*(131.46-e*(176.58-e*67.37)))))))+", "+Math.max(0,Math.min(255,Math.round(81.24+e*(442.36-e*(2482.43-e*(6167.24-e*(6614.94-e*2475.67)))))))+")"}var _m=Fl(kn(300,.5,0),kn(-240,.5,1)),vm=Fl(kn(-100,.75,.35),kn(80,1.5,.8)),bm=Fl(kn(260,.75,.35),kn(80,1.5,.8)),pu=kn();function Mm(e){(e<0||e>1)&&(e-=Math.floor(e));var t=Math.abs(e-.5);return pu.h=360*e-100,pu.s=1.5-1.5*t,pu.l=.8-.9*t,pu+""}var mu=ai(),MP=Math.PI/3,wP=Math.PI*2/3;function wm(e){var t;return e=(.5-e)*Math.PI,mu.r=255*(t=Math.sin(e))*t,mu.g=255*(t=Math.sin(e+MP))*t,mu.b=255*(t=Math.sin(e+wP))*t,mu+""}function Sm(e){return e=Math.max(0,Math.min(1,e)),"rgb("+Math.max(0,Math.min(255,Math.round(34.61+e*(1172.33-e*(10793.56-e*(33300.12-e*(38394.49-e*14825.05)))))))+", "+Math.max(0,Math.min(255,Math.round(23.31+e*(557.33+e*(1225.33-e*(3574.96-e*(1073.77+e*707.56)))))))+", "+Math.max(0,Math.min(255,Math.round(27.2+e*(3211.1-e*(15327.97-e*(27814-e*(22569.18-e*6838.66)))))))+")"}function xu(e){var t=e.length;return function(n){return e[Math.max(0,Math.min(t-1,Math.floor(n*t)))]}}var Tm=xu(Vt("44015444025645045745055946075a46085c460a5d460b5e470d60470e6147106347116447136548146748166848176948186a481a6c481b6d481c6e481d6f481f70482071482173482374482475482576482677482878482979472a7a472c7a472d7b472e7c472f7d46307e46327e46337f463480453581453781453882443983443a83443b84433d84433e85423f854240864241864142874144874045884046883f47883f48893e49893e4a893e4c8a3d4d8a3d4e8a3c4f8a3c508b3b518b3b528b3a538b3a548c39558c39568c38588c38598c375a8c375b8d365c8d365d8d355e8d355f8d34608d34618d33628d33638d32648e32658e31668e31678e31688e30698e306a8e2f6b8e2f6c8e2e6d8e2e6e8e2e6f8e2d708e2d718e2c718e2c728e2c738e2b748e2b758e2a768e2a778e2a788e29798e297a8e297b8e287c8e287d8e277e8e277f8e27808e26818e26828e26828e25838e25848e25858e24868e24878e23888e23898e238a8d228b8d228c8d228d8d218e8d218f8d21908d21918c20928c20928c20938c1f948c1f958b1f968b1f978b1f988b1f998a1f9a8a1e9b8a1e9c891e9d891f9e891f9f881fa0881fa1881fa1871fa28720a38620a48621a58521a68522a78522a88423a98324aa8325ab8225ac8226ad8127ad8128ae8029af7f2ab07f2cb17e2db27d2eb37c2fb47c31b57b32b67a34b67935b77937b87838b9773aba763bbb753dbc743fbc7340bd7242be7144bf7046c06f48c16e4ac16d4cc26c4ec36b50c46a52c56954c56856c66758c7655ac8645cc8635ec96260ca6063cb5f65cb5e67cc5c69cd5b6ccd5a6ece5870cf5773d05675d05477d1537ad1517cd2507fd34e81d34d84d44b86d54989d5488bd6468ed64590d74393d74195d84098d83e9bd93c9dd93ba0da39a2da37a5db36a8db34aadc32addc30b0dd2fb2dd2db5de2bb8de29bade28bddf26c0df25c2df23c5e021c8e020cae11fcde11dd0e11cd2e21bd5e21ad8e219dae319dde318dfe318e2e418e5e419e7e419eae51aece51befe51cf1e51df4e61ef6e620f8e621fbe723fde725")),Em=xu(Vt("00000401000501010601010802010902020b02020d03030f03031204041405041606051806051a07061c08071e0907200a08220b09240c09260d0a290e0b2b100b2d110c2f120d31130d34140e36150e38160f3b180f3d19103f1a10421c10441d11471e114920114b21114e22115024125325125527125829115a2a115c2c115f2d11612f116331116533106734106936106b38106c390f6e3b0f703d0f713f0f72400f74420f75440f764510774710784910784a10794c117a4e117b4f127b51127c52137c54137d56147d57157e59157e5a167e5c167f5d177f5f187f601880621980641a80651a80671b80681c816a1c816b1d816d1d816e1e81701f81721f817320817521817621817822817922827b23827c23827e24828025828125818326818426818627818827818928818b29818c29818e2a81902a81912b81932b80942c80962c80982d80992d809b2e7f9c2e7f9e2f7fa02f7fa1307ea3307ea5317ea6317da8327daa337dab337cad347cae347bb0357bb2357bb3367ab5367ab73779b83779ba3878bc3978bd3977bf3a77c03a76c23b75c43c75c53c74c73d73c83e73ca3e72cc3f71cd4071cf4070d0416fd2426fd3436ed5446dd6456cd8456cd9466bdb476adc4869de4968df4a68e04c67e24d66e34e65e44f64e55064e75263e85362e95462ea5661eb5760ec5860ed5a5fee5b5eef5d5ef05f5ef1605df2625df2645cf3655cf4675cf4695cf56b5cf66c5cf66e5cf7705cf7725cf8745cf8765cf9785df9795df97b5dfa7d5efa7f5efa815ffb835ffb8560fb8761fc8961fc8a62fc8c63fc8e64fc9065fd9266fd9467fd9668fd9869fd9a6afd9b6bfe9d6cfe9f6dfea16efea36ffea571fea772fea973feaa74feac76feae77feb078feb27afeb47bfeb67cfeb77efeb97ffebb81febd82febf84fec185fec287fec488fec68afec88cfeca8dfecc8ffecd90fecf92fed194fed395fed597fed799fed89afdda9cfddc9efddea0fde0a1fde2a3fde3a5fde5a7fde7a9fde9aafdebacfcecaefceeb0fcf0b2fcf2b4fcf4b6fcf6b8fcf7b9fcf9bbfcfbbdfcfdbf")),Am=xu(Vt("00000401000501010601010802010a02020c02020e03021004031204031405041706041907051b08051d09061f0a07220b07240c08260d08290e092b10092d110a30120a32140b34150b37160b39180c3c190c3e1b0c411c0c431e0c451f0c48210c4a230c4c240c4f260c51280b53290b552b0b572d0b592f0a5b310a5c320a5e340a5f3609613809623909633b09643d09653e0966400a67420a68440a68450a69470b6a490b6a4a0c6b4c0c6b4d0d6c4f0d6c510e6c520e6d540f6d550f6d57106e59106e5a116e5c126e5d126e5f136e61136e62146e64156e65156e67166e69166e6a176e6c186e6d186e6f196e71196e721a6e741a6e751b6e771c6d781c6d7a1d6d7c1d6d7d1e6d7f1e6c801f6c82206c84206b85216b87216b88226a8a226a8c23698d23698f24699025689225689326679526679727669827669a28659b29649d29649f2a63a02a63a22b62a32c61a52c60a62d60a82e5fa92e5eab2f5ead305dae305cb0315bb1325ab3325ab43359b63458b73557b93556ba3655bc3754bd3853bf3952c03a51c13a50c33b4fc43c4ec63d4dc73e4cc83f4bca404acb4149cc4248ce4347cf4446d04545d24644d34743d44842d54a41d74b3fd84c3ed94d3dda4e3cdb503bdd513ade5238df5337e05536e15635e25734e35933e45a31e55c30e65d2fe75e2ee8602de9612bea632aeb6429eb6628ec6726ed6925ee6a24ef6c23ef6e21f06f20f1711ff1731df2741cf3761bf37819f47918f57b17f57d15f67e14f68013f78212f78410f8850ff8870ef8890cf98b0bf98c0af98e09fa9008fa9207fa9407fb9606fb9706fb9906fb9b06fb9d07fc9f07fca108fca309fca50afca60cfca80dfcaa0ffcac11fcae12fcb014fcb216fcb418fbb61afbb81dfbba1ffbbc21fbbe23fac026fac228fac42afac62df9c72ff9c932f9cb35f8cd37f8cf3af7d13df7d340f6d543f6d746f5d949f5db4cf4dd4ff4df53f4e156f3e35af3e55df2e661f2e865f2ea69f1ec6df1ed71f1ef75f1f179f2f27df2f482f3f586f3f68af4f88ef5f992f6fa96f8fb9af9fc9dfafda1fcffa4")),Cm=xu(Vt("0d088710078813078916078a19068c1b068d1d068e20068f2206902406912605912805922a05932c05942e05952f059631059733059735049837049938049a3a049a3c049b3e049c3f049c41049d43039e44039e46039f48039f4903a04b03a14c02a14e02a25002a25102a35302a35502a45601a45801a45901a55b01a55c01a65e01a66001a66100a76300a76400a76600a76700a86900a86a00a86c00a86e00a86f00a87100a87201a87401a87501a87701a87801a87a02a87b02a87d03a87e03a88004a88104a78305a78405a78606a68707a68808a68a09a58b0aa58d0ba58e0ca48f0da4910ea3920fa39410a29511a19613a19814a099159f9a169f9c179e9d189d9e199da01a9ca11b9ba21d9aa31e9aa51f99a62098a72197a82296aa2395ab2494ac2694ad2793ae2892b02991b12a90b22b8fb32c8eb42e8db52f8cb6308bb7318ab83289ba3388bb3488bc3587bd3786be3885bf3984c03a83c13b82c23c81c33d80c43e7fc5407ec6417dc7427cc8437bc9447aca457acb4679cc4778cc4977cd4a76ce4b75cf4c74d04d73d14e72d24f71d35171d45270d5536fd5546ed6556dd7566cd8576bd9586ada5a6ada5b69db5c68dc5d67dd5e66de5f65de6164df6263e06363e16462e26561e26660e3685fe4695ee56a5de56b5de66c5ce76e5be76f5ae87059e97158e97257ea7457eb7556eb7655ec7754ed7953ed7a52ee7b51ef7c51ef7e50f07f4ff0804ef1814df1834cf2844bf3854bf3874af48849f48948f58b47f58c46f68d45f68f44f79044f79143f79342f89441f89540f9973ff9983ef99a3efa9b3dfa9c3cfa9e3bfb9f3afba139fba238fca338fca537fca636fca835fca934fdab33fdac33fdae32fdaf31fdb130fdb22ffdb42ffdb52efeb72dfeb82cfeba2cfebb2bfebd2afebe2afec029fdc229fdc328fdc527fdc627fdc827fdca26fdcb26fccd25fcce25fcd025fcd225fbd324fbd524fbd724fad824fada24f9dc24f9dd25f8df25f8e125f7e225f7e425f6e626f6e826f5e926f5eb27f4ed27f3ee27f3f027f2f227f1f426f1f525f0f724f0f921"));function $e(e){return function(){return e}}var z1=Math.cos;var Lm=Math.min,_u=Math.sin,ke=Math.sqrt,U1=1e-12,Ec=Math.PI,M8=Ec/2,Su=2*Ec;function V1(e){let t=3;return e.digits=function(n){if(!arguments.length)return t;if(n==null)t=null;else{let i=Math.floor(n);if(!(i>=0))throw new RangeError(`invalid digits: ${n}`);t=i}return e},()=>new Ms(t)}var w8=Array.prototype.slice;function H1(e){return typeof e=="object"&&"length"in e?e:Array.from(e)}function G1(e){this._context=e}G1.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._point=0},lineEnd:function(){(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1,this._line?this._context.lineTo(e,t):this._context.moveTo(e,t);break;case 1:this._point=2;default:this._context.lineTo(e,t);break}}};function Ds(e){return new G1(e)}function W1(e){return e[0]}function $1(e){return e[1]}function Nm(e,t){var n=$e(!0),i=null,r=Ds,s=null,o=V1(a);e=typeof e=="function"?e:e===void 0?W1:$e(e),t=typeof t=="function"?t:t===void 0?$1:$e(t);function a(c){var l,u=(c=H1(c)).length,h,f=!1,d;for(i==null&&(s=r(d=o())),l=0;l<=u;++l)!(l<u&&n(h=c[l],l,c))===f&&((f=!f)?s.lineStart():s.lineEnd()),f&&s.point(+e(h,l,c),+t(h,l,c));if(d)return s=null,d+""||null}return a.x=function(c){return arguments.length?(e=typeof c=="function"?c:$e(+c),a):e},a.y=function(c){return arguments.length?(t=typeof c=="function"?c:$e(+c),a):t},a.defined=function(c){return arguments.length?(n=typeof c=="function"?c:$e(!!c),a):n},a.curve=function(c){return arguments.length?(r=c,i!=null&&(s=r(i)),a):r},a.context=function(c){return arguments.length?(c==null?i=s=null:s=r(i=c),a):i},a}function X1(e,t,n){var i=null,r=$e(!0),s=null,o=Ds,a=null,c=V1(l);e=typeof e=="function"?e:e===void 0?W1:$e(+e),t=typeof t=="function"?t:$e(t===void 0?0:+t),n=typeof n=="function"?n:n===void 0?$1:$e(+n);function l(h){var f,d,m,y=(h=H1(h)).length,g,p=!1,_,b=new Array(y),x=new Array(y);for(s==null&&(a=o(_=c())),f=0;f<=y;++f){if(!(f<y&&r(g=h[f],f,h))===p)if(p=!p)d=f,a.areaStart(),a.lineStart();else{for(a.lineEnd(),a.lineStart(),m=f-1;m>=d;--m)a.point(b[m],x[m]);a.lineEnd(),a.areaEnd()}p&&(b[f]=+e(g,f,h),x[f]=+t(g,f,h),a.point(i?+i(g,f,h):b[f],n?+n(g,f,h):x[f]))}if(_)return a=null,_+""||null}function u(){return Nm().defined(r).curve(o).context(s)}return l.x=function(h){return arguments.length?(e=typeof h=="function"?h:$e(+h),i=null,l):e},l.x0=function(h){return arguments.length?(e=typeof h=="function"?h:$e(+h),l):e},l.x1=function(h){return arguments.length?(i=h==null?null:typeof h=="function"?h:$e(+h),l):i},l.y=function(h){return arguments.length?(t=typeof h=="function"?h:$e(+h),n=null,l):t},l.y0=function(h){return arguments.length?(t=typeof h=="function"?h:$e(+h),l):t},l.y1=function(h){return arguments.length?(n=h==null?null:typeof h=="function"?h:$e(+h),l):n},l.lineX0=l.lineY0=function(){return u().x(e).y(t)},l.lineY1=function(){return u().x(e).y(n)},l.lineX1=function(){return u().x(i).y(t)},l.defined=function(h){return arguments.length?(r=typeof h=="function"?h:$e(!!h),l):r},l.curve=function(h){return arguments.length?(o=h,s!=null&&(a=o(s)),l):o},l.context=function(h){return arguments.length?(h==null?s=a=null:a=o(s=h),l):s},l}var S8=SP(Ds);function Y1(e){this._curve=e}Y1.prototype={areaStart:function(){this._curve.areaStart()},areaEnd:function(){this._curve.areaEnd()},lineStart:function(){this._curve.lineStart()},lineEnd:function(){this._curve.lineEnd()},point:function(e,t){this._curve.point(t*Math.sin(e),t*-Math.cos(e))}};function SP(e){function t(n){return new Y1(e(n))}return t._curve=e,t}var vu=class{constructor(t,n){this._context=t,this._x=n}areaStart(){this._line=0}areaEnd(){this._line=NaN}lineStart(){this._point=0}lineEnd(){(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line=1-this._line}point(t,n){switch(t=+t,n=+n,this._point){case 0:{this._point=1,this._line?this._context.lineTo(t,n):this._context.moveTo(t,n);break}case 1:this._point=2;default:{this._x?this._context.bezierCurveTo(this._x0=(this._x0+t)/2,this._y0,this._x0,n,t,n):this._context.bezierCurveTo(this._x0,this._y0=(this._y0+n)/2,t,this._y0,t,n);break}}this._x0=t,this._y0=n}};function q1(e){return new vu(e,!0)}function Z1(e){return new vu(e,!1)}var TP=ke(3),Dm={draw(e,t){let n=ke(t+Lm(t/28,.75))*.59436,i=n/2,r=i*TP;e.moveTo(0,n),e.lineTo(0,-n),e.moveTo(-r,-i),e.lineTo(r,i),e.moveTo(-r,i),e.lineTo(r,-i)}},Us={draw(e,t){let n=ke(t/Ec);e.moveTo(n,0),e.arc(0,0,n,0,Su)}},Um={draw(e,t){let n=ke(t/5)/2;e.moveTo(-3*n,-n),e.lineTo(-n,-n),e.lineTo(-n,-3*n),e.lineTo(n,-3*n),e.lineTo(n,-n),e.lineTo(3*n,-n),e.lineTo(3*n,n),e.lineTo(n,n),e.lineTo(n,3*n),e.lineTo(-n,3*n),e.lineTo(-n,n),e.lineTo(-3*n,n),e.closePath()}},J1=ke(1/3),EP=J1*2,Fm={draw(e,t){let n=ke(t/EP),i=n*J1;e.moveTo(0,-n),e.lineTo(i,0),e.lineTo(0,n),e.lineTo(-i,0),e.closePath()}},Om={draw(e,t){let n=ke(t)*.62625;e.moveTo(0,-n),e.lineTo(n,0),e.lineTo(0,n),e.lineTo(-n,0),e.closePath()}},Bm={draw(e,t){let n=ke(t-Lm(t/7,2))*.87559;e.moveTo(-n,0),e.lineTo(n,0),e.moveTo(0,n),e.lineTo(0,-n)}},km={draw(e,t){let n=ke(t),i=-n/2;e.rect(i,i,n,n)}},zm={draw(e,t){let n=ke(t)*.4431;e.moveTo(n,n),e.lineTo(n,-n),e.lineTo(-n,-n),e.lineTo(-n,n),e.closePath()}},AP=.8908130915292852,K1=_u(Ec/10)/_u(7*Ec/10),CP=_u(Su/10)*K1,RP=-z1(Su/10)*K1,Vm={draw(e,t){let n=ke(t*AP),i=CP*n,r=RP*n;e.moveTo(0,-n),e.lineTo(i,r);for(let s=1;s<5;++s){let o=Su*s/5,a=z1(o),c=_u(o);e.lineTo(c*n,-a*n),e.lineTo(a*i-c*r,c*i+a*r)}e.closePath()}},Rm=ke(3),Hm={draw(e,t){let n=-ke(t/(Rm*3));e.moveTo(0,n*2),e.lineTo(-Rm*n,-n),e.lineTo(Rm*n,-n),e.closePath()}},IP=ke(3),Gm={draw(e,t){let n=ke(t)*.6824,i=n/2,r=n*IP/2;e.moveTo(0,-n),e.lineTo(r,i),e.lineTo(-r,i),e.closePath()}},Xn=-.5,Yn=ke(3)/2,Pm=1/ke(12),PP=(Pm/2+1)*3,Wm={draw(e,t){let n=ke(t/PP),i=n/2,r=n*Pm,s=i,o=n*Pm+n,a=-s,c=o;e.moveTo(i,r),e.lineTo(s,o),e.lineTo(a,c),e.lineTo(Xn*i-Yn*r,Yn*i+Xn*r),e.lineTo(Xn*s-Yn*o,Yn*s+Xn*o),e.lineTo(Xn*a-Yn*c,Yn*a+Xn*c),e.lineTo(Xn*i+Yn*r,Xn*r-Yn*i),e.lineTo(Xn*s+Yn*o,Xn*o-Yn*s),e.lineTo(Xn*a+Yn*c,Xn*c-Yn*a),e.closePath()}},$m={draw(e,t){let n=ke(t-Lm(t/6,1.7))*.6189;e.moveTo(-n,-n),e.lineTo(n,n),e.moveTo(-n,n),e.lineTo(n,-n)}},j1=[Us,Um,Fm,km,Vm,Hm,Wm],Q1=[Us,Bm,$m,Gm,Dm,zm,Om];function Or(){}function bu(e,t,n){e._context.bezierCurveTo((2*e._x0+e._x1)/3,(2*e._y0+e._y1)/3,(e._x0+2*e._x1)/3,(e._y0+2*e._y1)/3,(e._x0+4*e._x1+t)/6,(e._y0+4*e._y1+n)/6)}function Tu(e){this._context=e}Tu.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._y0=this._y1=NaN,this._point=0},lineEnd:function(){switch(this._point){case 3:bu(this,this._x1,this._y1);case 2:this._context.lineTo(this._x1,this._y1);break}(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1,this._line?this._context.lineTo(e,t):this._context.moveTo(e,t);break;case 1:this._point=2;break;case 2:this._point=3,this._context.lineTo((5*this._x0+this._x1)/6,(5*this._y0+this._y1)/6);default:bu(this,e,t);break}this._x0=this._x1,this._x1=e,this._y0=this._y1,this._y1=t}};function tM(e){return new Tu(e)}function eM(e){this._context=e}eM.prototype={areaStart:Or,areaEnd:Or,lineStart:function(){this._x0=this._x1=this._x2=this._x3=this._x4=this._y0=this._y1=this._y2=this._y3=this._y4=NaN,this._point=0},lineEnd:function(){switch(this._point){case 1:{this._context.moveTo(this._x2,this._y2),this._context.closePath();break}case 2:{this._context.moveTo((this._x2+2*this._x3)/3,(this._y2+2*this._y3)/3),this._context.lineTo((this._x3+2*this._x2)/3,(this._y3+2*this._y2)/3),this._context.closePath();break}case 3:{this.point(this._x2,this._y2),this.point(this._x3,this._y3),this.point(this._x4,this._y4);break}}},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1,this._x2=e,this._y2=t;break;case 1:this._point=2,this._x3=e,this._y3=t;break;case 2:this._point=3,this._x4=e,this._y4=t,this._context.moveTo((this._x0+4*this._x1+e)/6,(this._y0+4*this._y1+t)/6);break;default:bu(this,e,t);break}this._x0=this._x1,this._x1=e,this._y0=this._y1,this._y1=t}};function nM(e){return new eM(e)}function iM(e){this._context=e}iM.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._y0=this._y1=NaN,this._point=0},lineEnd:function(){(this._line||this._line!==0&&this._point===3)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1;break;case 1:this._point=2;break;case 2:this._point=3;var n=(this._x0+4*this._x1+e)/6,i=(this._y0+4*this._y1+t)/6;this._line?this._context.lineTo(n,i):this._context.moveTo(n,i);break;case 3:this._point=4;default:bu(this,e,t);break}this._x0=this._x1,this._x1=e,this._y0=this._y1,this._y1=t}};function rM(e){return new iM(e)}function sM(e,t){this._basis=new Tu(e),this._beta=t}sM.prototype={lineStart:function(){this._x=[],this._y=[],this._basis.lineStart()},lineEnd:function(){var e=this._x,t=this._y,n=e.length-1;if(n>0)for(var i=e[0],r=t[0],s=e[n]-i,o=t[n]-r,a=-1,c;++a<=n;)c=a/n,this._basis.point(this._beta*e[a]+(1-this._beta)*(i+c*s),this._beta*t[a]+(1-this._beta)*(r+c*o));this._x=this._y=null,this._basis.lineEnd()},point:function(e,t){this._x.push(+e),this._y.push(+t)}};var oM=function e(t){function n(i){return t===1?new Tu(i):new sM(i,t)}return n.beta=function(i){return e(+i)},n}(.85);function Mu(e,t,n){e._context.bezierCurveTo(e._x1+e._k*(e._x2-e._x0),e._y1+e._k*(e._y2-e._y0),e._x2+e._k*(e._x1-t),e._y2+e._k*(e._y1-n),e._x2,e._y2)}function Xm(e,t){this._context=e,this._k=(1-t)/6}Xm.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._x2=this._y0=this._y1=this._y2=NaN,this._point=0},lineEnd:function(){switch(this._point){case 2:this._context.lineTo(this._x2,this._y2);break;case 3:Mu(this,this._x1,this._y1);break}(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1,this._line?this._context.lineTo(e,t):this._context.moveTo(e,t);break;case 1:this._point=2,this._x1=e,this._y1=t;break;case 2:this._point=3;default:Mu(this,e,t);break}this._x0=this._x1,this._x1=this._x2,this._x2=e,this._y0=this._y1,this._y1=this._y2,this._y2=t}};var aM=function e(t){function n(i){return new Xm(i,t)}return n.tension=function(i){return e(+i)},n}(0);function Ym(e,t){this._context=e,this._k=(1-t)/6}Ym.prototype={areaStart:Or,areaEnd:Or,lineStart:function(){this._x0=this._x1=this._x2=this._x3=this._x4=this._x5=this._y0=this._y1=this._y2=this._y3=this._y4=this._y5=NaN,this._point=0},lineEnd:function(){switch(this._point){case 1:{this._context.moveTo(this._x3,this._y3),this._context.closePath();break}case 2:{this._context.lineTo(this._x3,this._y3),this._context.closePath();break}case 3:{this.point(this._x3,this._y3),this.point(this._x4,this._y4),this.point(this._x5,this._y5);break}}},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1,this._x3=e,this._y3=t;break;case 1:this._point=2,this._context.moveTo(this._x4=e,this._y4=t);break;case 2:this._point=3,this._x5=e,this._y5=t;break;default:Mu(this,e,t);break}this._x0=this._x1,this._x1=this._x2,this._x2=e,this._y0=this._y1,this._y1=this._y2,this._y2=t}};var cM=function e(t){function n(i){return new Ym(i,t)}return n.tension=function(i){return e(+i)},n}(0);function qm(e,t){this._context=e,this._k=(1-t)/6}qm.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._x2=this._y0=this._y1=this._y2=NaN,this._point=0},lineEnd:function(){(this._line||this._line!==0&&this._point===3)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1;break;case 1:this._point=2;break;case 2:this._point=3,this._line?this._context.lineTo(this._x2,this._y2):this._context.moveTo(this._x2,this._y2);break;case 3:this._point=4;default:Mu(this,e,t);break}this._x0=this._x1,this._x1=this._x2,this._x2=e,this._y0=this._y1,this._y1=this._y2,this._y2=t}};var lM=function e(t){function n(i){return new qm(i,t)}return n.tension=function(i){return e(+i)},n}(0);function Zm(e,t,n){var i=e._x1,r=e._y1,s=e._x2,o=e._y2;if(e._l01_a>U1){var a=2*e._l01_2a+3*e._l01_a*e._l12_a+e._l12_2a,c=3*e._l01_a*(e._l01_a+e._l12_a);i=(i*a-e._x0*e._l12_2a+e._x2*e._l01_2a)/c,r=(r*a-e._y0*e._l12_2a+e._y2*e._l01_2a)/c}if(e._l23_a>U1){var l=2*e._l23_2a+3*e._l23_a*e._l12_a+e._l12_2a,u=3*e._l23_a*(e._l23_a+e._l12_a);s=(s*l+e._x1*e._l23_2a-t*e._l12_2a)/u,o=(o*l+e._y1*e._l23_2a-n*e._l12_2a)/u}e._context.bezierCurveTo(i,r,s,o,e._x2,e._y2)}function uM(e,t){this._context=e,this._alpha=t}uM.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._x2=this._y0=this._y1=this._y2=NaN,this._l01_a=this._l12_a=this._l23_a=this._l01_2a=this._l12_2a=this._l23_2a=this._point=0},lineEnd:function(){switch(this._point){case 2:this._context.lineTo(this._x2,this._y2);break;case 3:this.point(this._x2,this._y2);break}(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){if(e=+e,t=+t,this._point){var n=this._x2-e,i=this._y2-t;this._l23_a=Math.sqrt(this._l23_2a=Math.pow(n*n+i*i,this._alpha))}switch(this._point){case 0:this._point=1,this._line?this._context.lineTo(e,t):this._context.moveTo(e,t);break;case 1:this._point=2;break;case 2:this._point=3;default:Zm(this,e,t);break}this._l01_a=this._l12_a,this._l12_a=this._l23_a,this._l01_2a=this._l12_2a,this._l12_2a=this._l23_2a,this._x0=this._x1,this._x1=this._x2,this._x2=e,this._y0=this._y1,this._y1=this._y2,this._y2=t}};var fM=function e(t){function n(i){return t?new uM(i,t):new Xm(i,0)}return n.alpha=function(i){return e(+i)},n}(.5);function hM(e,t){this._context=e,this._alpha=t}hM.prototype={areaStart:Or,areaEnd:Or,lineStart:function(){this._x0=this._x1=this._x2=this._x3=this._x4=this._x5=this._y0=this._y1=this._y2=this._y3=this._y4=this._y5=NaN,this._l01_a=this._l12_a=this._l23_a=this._l01_2a=this._l12_2a=this._l23_2a=this._point=0},lineEnd:function(){switch(this._point){case 1:{this._context.moveTo(this._x3,this._y3),this._context.closePath();break}case 2:{this._context.lineTo(this._x3,this._y3),this._context.closePath();break}case 3:{this.point(this._x3,this._y3),this.point(this._x4,this._y4),this.point(this._x5,this._y5);break}}},point:function(e,t){if(e=+e,t=+t,this._point){var n=this._x2-e,i=this._y2-t;this._l23_a=Math.sqrt(this._l23_2a=Math.pow(n*n+i*i,this._alpha))}switch(this._point){case 0:this._point=1,this._x3=e,this._y3=t;break;case 1:this._point=2,this._context.moveTo(this._x4=e,this._y4=t);break;case 2:this._point=3,this._x5=e,this._y5=t;break;default:Zm(this,e,t);break}this._l01_a=this._l12_a,this._l12_a=this._l23_a,this._l01_2a=this._l12_2a,this._l12_2a=this._l23_2a,this._x0=this._x1,this._x1=this._x2,this._x2=e,this._y0=this._y1,this._y1=this._y2,this._y2=t}};var dM=function e(t){function n(i){return t?new hM(i,t):new Ym(i,0)}return n.alpha=function(i){return e(+i)},n}(.5);function pM(e,t){this._context=e,this._alpha=t}pM.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._x2=this._y0=this._y1=this._y2=NaN,this._l01_a=this._l12_a=this._l23_a=this._l01_2a=this._l12_2a=this._l23_2a=this._point=0},lineEnd:function(){(this._line||this._line!==0&&this._point===3)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){if(e=+e,t=+t,this._point){var n=this._x2-e,i=this._y2-t;this._l23_a=Math.sqrt(this._l23_2a=Math.pow(n*n+i*i,this._alpha))}switch(this._point){case 0:this._point=1;break;case 1:this._point=2;break;case 2:this._point=3,this._line?this._context.lineTo(this._x2,this._y2):this._context.moveTo(this._x2,this._y2);break;case 3:this._point=4;default:Zm(this,e,t);break}this._l01_a=this._l12_a,this._l12_a=this._l23_a,this._l01_2a=this._l12_2a,this._l12_2a=this._l23_2a,this._x0=this._x1,this._x1=this._x2,this._x2=e,this._y0=this._y1,this._y1=this._y2,this._y2=t}};var mM=function e(t){function n(i){return t?new pM(i,t):new qm(i,0)}return n.alpha=function(i){return e(+i)},n}(.5);function gM(e){this._context=e}gM.prototype={areaStart:Or,areaEnd:Or,lineStart:function(){this._point=0},lineEnd:function(){this._point&&this._context.closePath()},point:function(e,t){e=+e,t=+t,this._point?this._context.lineTo(e,t):(this._point=1,this._context.moveTo(e,t))}};function yM(e){return new gM(e)}function F1(e){return e<0?-1:1}function O1(e,t,n){var i=e._x1-e._x0,r=t-e._x1,s=(e._y1-e._y0)/(i||r<0&&-0),o=(n-e._y1)/(r||i<0&&-0),a=(s*r+o*i)/(i+r);return(F1(s)+F1(o))*Math.min(Math.abs(s),Math.abs(o),.5*Math.abs(a))||0}function B1(e,t){var n=e._x1-e._x0;return n?(3*(e._y1-e._y0)/n-t)/2:t}function Im(e,t,n){var i=e._x0,r=e._y0,s=e._x1,o=e._y1,a=(s-i)/3;e._context.bezierCurveTo(i+a,r+a*t,s-a,o-a*n,s,o)}function wu(e){this._context=e}wu.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x0=this._x1=this._y0=this._y1=this._t0=NaN,this._point=0},lineEnd:function(){switch(this._point){case 2:this._context.lineTo(this._x1,this._y1);break;case 3:Im(this,this._t0,B1(this,this._t0));break}(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line=1-this._line},point:function(e,t){var n=NaN;if(e=+e,t=+t,!(e===this._x1&&t===this._y1)){switch(this._point){case 0:this._point=1,this._line?this._context.lineTo(e,t):this._context.moveTo(e,t);break;case 1:this._point=2;break;case 2:this._point=3,Im(this,B1(this,n=O1(this,e,t)),n);break;default:Im(this,this._t0,n=O1(this,e,t));break}this._x0=this._x1,this._x1=e,this._y0=this._y1,this._y1=t,this._t0=n}}};function xM(e){this._context=new _M(e)}(xM.prototype=Object.create(wu.prototype)).point=function(e,t){wu.prototype.point.call(this,t,e)};function _M(e){this._context=e}_M.prototype={moveTo:function(e,t){this._context.moveTo(t,e)},closePath:function(){this._context.closePath()},lineTo:function(e,t){this._context.lineTo(t,e)},bezierCurveTo:function(e,t,n,i,r,s){this._context.bezierCurveTo(t,e,i,n,s,r)}};function vM(e){return new wu(e)}function bM(e){return new xM(e)}function MM(e){this._context=e}MM.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x=[],this._y=[]},lineEnd:function(){var e=this._x,t=this._y,n=e.length;if(n)if(this._line?this._context.lineTo(e[0],t[0]):this._context.moveTo(e[0],t[0]),n===2)this._context.lineTo(e[1],t[1]);else for(var i=k1(e),r=k1(t),s=0,o=1;o<n;++s,++o)this._context.bezierCurveTo(i[0][s],r[0][s],i[1][s],r[1][s],e[o],t[o]);(this._line||this._line!==0&&n===1)&&this._context.closePath(),this._line=1-this._line,this._x=this._y=null},point:function(e,t){this._x.push(+e),this._y.push(+t)}};function k1(e){var t,n=e.length-1,i,r=new Array(n),s=new Array(n),o=new Array(n);for(r[0]=0,s[0]=2,o[0]=e[0]+2*e[1],t=1;t<n-1;++t)r[t]=1,s[t]=4,o[t]=4*e[t]+2*e[t+1];for(r[n-1]=2,s[n-1]=7,o[n-1]=8*e[n-1]+e[n],t=1;t<n;++t)i=r[t]/s[t-1],s[t]-=i,o[t]-=i*o[t-1];for(r[n-1]=o[n-1]/s[n-1],t=n-2;t>=0;--t)r[t]=(o[t]-r[t+1])/s[t];for(s[n-1]=(e[n]+r[n-1])/2,t=0;t<n-1;++t)s[t]=2*e[t+1]-r[t+1];return[r,s]}function wM(e){return new MM(e)}function Eu(e,t){this._context=e,this._t=t}Eu.prototype={areaStart:function(){this._line=0},areaEnd:function(){this._line=NaN},lineStart:function(){this._x=this._y=NaN,this._point=0},lineEnd:function(){0<this._t&&this._t<1&&this._point===2&&this._context.lineTo(this._x,this._y),(this._line||this._line!==0&&this._point===1)&&this._context.closePath(),this._line>=0&&(this._t=1-this._t,this._line=1-this._line)},point:function(e,t){switch(e=+e,t=+t,this._point){case 0:this._point=1,this._line?this._context.lineTo(e,t):this._context.moveTo(e,t);break;case 1:this._point=2;default:{if(this._t<=0)this._context.lineTo(this._x,t),this._context.lineTo(e,t);else{var n=this._x*(1-this._t)+e*this._t;this._context.lineTo(n,this._y),this._context.lineTo(n,t)}break}}this._x=e,this._y=t}};function SM(e){return new Eu(e,.5)}function TM(e){return new Eu(e,0)}function EM(e){return new Eu(e,1)}function qn(e){return e!=null&&!Number.isNaN(e)}function en(e,t){return+qn(t)-+qn(e)||tn(e,t)}function Fs(e,t){return+qn(t)-+qn(e)||Zi(e,t)}function Ac(e){return e!=null&&`${e}`!=""}function Jm(e){return isFinite(e)?e:NaN}function Os(e){return e>0&&isFinite(e)?e:NaN}function ko(e){return e<0&&isFinite(e)?e:NaN}function Au(e,t){if(e instanceof Date||(e=new Date(+e)),isNaN(e))return typeof t=="function"?t(e):t;let n=e.getUTCHours(),i=e.getUTCMinutes(),r=e.getUTCSeconds(),s=e.getUTCMilliseconds();return`${LP(e.getUTCFullYear(),4)}-${sr(e.getUTCMonth()+1,2)}-${sr(e.getUTCDate(),2)}${n||i||r||s?`T${sr(n,2)}:${sr(i,2)}${r||s?`:${sr(r,2)}${s?`.${sr(s,3)}`:""}`:""}Z`:""}`}function LP(e){return e<0?`-${sr(-e,6)}`:e>9999?`+${sr(e,6)}`:sr(e,4)}function sr(e,t){return`${e}`.padStart(t,"0")}var NP=/^(?:[-+]\d{2})?\d{4}(?:-\d{2}(?:-\d{2})?)?(?:T\d{2}:\d{2}(?::\d{2}(?:\.\d{3})?)?(?:Z|[-+]\d{2}:?\d{2})?)?$/;function Cc(e,t){return NP.test(e+="")?new Date(e):typeof t=="function"?t(e):t}function or(e){if(e==null)return;let t=e[0],n=e[e.length-1];return Zi(t,n)}var Vo=1e3,kr=Vo*60,zr=kr*60,Ui=zr*24,Di=Ui*7,Bs=Ui*30,Br=Ui*365,Km=[["millisecond",1],["2 milliseconds",2],["5 milliseconds",5],["10 milliseconds",10],["20 milliseconds",20],["50 milliseconds",50],["100 milliseconds",100],["200 milliseconds",200],["500 milliseconds",500],["second",Vo],["5 seconds",5*Vo],["15 seconds",15*Vo],["30 seconds",30*Vo],["minute",kr],["5 minutes",5*kr],["15 minutes",15*kr],["30 minutes",30*kr],["hour",zr],["3 hours",3*zr],["6 hours",6*zr],["12 hours",12*zr],["day",Ui],["2 days",2*Ui],["week",Di],["2 weeks",2*Di],["month",Bs],["3 months",3*Bs],["6 months",6*Bs],["year",Br],["2 years",2*Br],["5 years",5*Br],["10 years",10*Br],["20 years",20*Br],["50 years",50*Br],["100 years",100*Br]],jm=new Map([["second",Vo],["minute",kr],["hour",zr],["day",Ui],["monday",Di],["tuesday",Di],["wednesday",Di],["thursday",Di],["friday",Di],["saturday",Di],["sunday",Di],["week",Di],["month",Bs],["year",Br]]),CM=new Map([["second",cn],["minute",Ss],["hour",Es],["day",Ri],["monday",Rs],["tuesday",Qd],["wednesday",tp],["thursday",ir],["friday",ep],["saturday",np],["sunday",Ii],["week",Ii],["month",Ls],["year",gn]]),Qm=new Map([["second",cn],["minute",Ts],["hour",As],["day",gc],["monday",Ps],["tuesday",ip],["wednesday",rp],["thursday",rr],["friday",sp],["saturday",op],["sunday",Pi],["week",Pi],["month",Ns],["year",yn]]),Ho=Symbol("intervalDuration"),Ru=Symbol("intervalType");for(let[e,t]of CM)t[Ho]=jm.get(e),t[Ru]="time";for(let[e,t]of Qm)t[Ho]=jm.get(e),t[Ru]="utc";var Rc=[["year",yn,"utc"],["month",Ns,"utc"],["day",gc,"utc",6*Bs],["hour",As,"utc",3*Ui],["minute",Ts,"utc",6*zr],["second",cn,"utc",30*kr]],Cu=[["year",gn,"time"],["month",Ls,"time"],["day",Ri,"time",6*Bs],["hour",Es,"time",3*Ui],["minute",Ss,"time",6*zr],["second",cn,"time",30*kr]],DP=[Rc[0],Cu[0],Rc[1],Cu[1],Rc[2],Cu[2],...Rc.slice(3)];function RM(e){let t=`${e}`.toLowerCase();t.endsWith("s")&&(t=t.slice(0,-1));let n=1,i=/^(?:(\d+)\s+)/.exec(t);switch(i&&(t=t.slice(i[0].length),n=+i[1]),t){case"quarter":t="month",n*=3;break;case"half":t="month",n*=6;break}let r=Qm.get(t);if(!r)throw new Error(`unknown interval: ${e}`);if(n>1&&!r.every)throw new Error(`non-periodic interval: ${t}`);return[t,n]}function tg(e){return IM(RM(e),"time")}function Ic(e){return IM(RM(e),"utc")}function IM([e,t],n){let i=(n==="time"?CM:Qm).get(e);return t>1&&(i=i.every(t),i[Ho]=jm.get(e)*t,i[Ru]=n),i}function eg(e,t){if(!(t>1))return;let n=e[Ho];if(!Km.some(([,r])=>r===n)||n%Ui===0&&Ui<n&&n<Bs)return;let[i]=Km[_o(([,r])=>Math.log(r)).center(Km,Math.log(n*t))];return(e[Ru]==="time"?tg:Ic)(i)}function AM(e,t,n){let i=t==="time"?vc:Li;if(n==null)return i(e==="year"?"%Y":e==="month"?"%Y-%m":e==="day"?"%Y-%m-%d":e==="hour"||e==="minute"?"%Y-%m-%dT%H:%M":e==="second"?"%Y-%m-%dT%H:%M:%S":"%Y-%m-%dT%H:%M:%S.%L");let r=UP(n);switch(e){case"millisecond":return zo(i(".%L"),i(":%M:%S"),r);case"second":return zo(i(":%S"),i("%-I:%M"),r);case"minute":return zo(i("%-I:%M"),i("%p"),r);case"hour":return zo(i("%-I %p"),i("%b %-d"),r);case"day":return zo(i("%-d"),i("%b"),r);case"month":return zo(i("%b"),i("%Y"),r);case"year":return i("%Y")}throw new Error("unable to format time ticks")}function UP(e){return e==="left"||e==="right"?(t,n)=>`
${t}
${n}`:e==="top"?(t,n)=>`${n}
${t}`:(t,n)=>`${t}
${n}`}function FP(e){return e==="time"?Cu:e==="utc"?Rc:DP}function PM(e,t,n){let i=sn(A_(t,(r,s)=>Math.abs(s-r)));if(i<1e3)return AM("millisecond","utc",n);for(let[r,s,o,a]of FP(e)){if(i>a||r==="hour"&&!i)break;if(t.every(c=>s.floor(c)>=c))return AM(r,o,n)}}function zo(e,t,n){return(i,r,s)=>{let o=e(i,r),a=t(i,r),c=r-or(s);return r!==c&&s[c]!==void 0&&a===t(s[c],c)?o:n(o,a)}}var ig=Object.getPrototypeOf(Uint8Array),OP=Object.prototype.toString;function ci(e){return e instanceof Array||e instanceof ig}function DM(e){return e instanceof ig&&!BP(e)}function UM(e){return e?.prototype instanceof ig&&!kP(e)}function BP(e){return e instanceof BigInt64Array||e instanceof BigUint64Array}function kP(e){return e===BigInt64Array||e===BigUint64Array}var rg=Symbol("reindex");function ve(e,t,n){let i=typeof t;return i==="string"?QM(e)?sg(e.getChild(t),n):LM(e,og(t),n):i==="function"?LM(e,t,n):i==="number"||t instanceof Date||i==="boolean"?ue(e,An(t),n):typeof t?.transform=="function"?ng(t.transform(e),n):zP(ng(t,n),e?.[rg])}function zP(e,t){return e!=null&&t?Pu(e,t):e}function LM(e,t,n){return ue(e,UM(n)?(i,r)=>ag(t(i,r)):t,n)}function ng(e,t){return t===void 0?Oi(e):tw(e)?sg(e,t):e instanceof t?e:t.from(e,UM(t)&&!DM(e)?ag:void 0)}function sg(e,t){return e==null?e:(t===void 0||t===Array)&&WP(e.type)?cg(NM(e)):ng(NM(e),t)}function NM(e){return e.nullCount?e.toJSON():e.toArray()}var Go=[null],og=e=>t=>{let n=t[e];return n===void 0&&t.type==="Feature"?t.properties?.[e]:n},li={transform:fn},fe={transform:e=>e};var FM=()=>1,OM=()=>!0,Ie=e=>e==null?e:`${e}`,Pe=e=>e==null?e:+e;var Iu=e=>e?e[0]:void 0,Pc=e=>e?e[1]:void 0;var An=e=>()=>e;function BM(e){let t=+`${e}`.slice(1)/100;return(n,i)=>qi(n,t,i)}function Fi(e){return DM(e)?e:ue(e,ag,Float64Array)}function ag(e){return e==null?NaN:Number(e)}function cg(e){return ue(e,lg)}function lg(e){return e instanceof Date&&!isNaN(e)?e:typeof e=="string"?Cc(e):e==null||isNaN(e=Number(e))?void 0:new Date(e)}function ln(e,t){return e===void 0&&(e=t),e===null?[void 0,"none"]:qo(e)?[void 0,e]:[e,void 0]}function Ae(e,t){return e===void 0&&(e=t),e===null||typeof e=="number"?[void 0,e]:[e,void 0]}function ug(e,t,n){if(e!=null)return un(e,t,n)}function un(e,t,n){let i=`${e}`.toLowerCase();if(!n.includes(i))throw new Error(`invalid ${t}: ${e}`);return i}function ar(e){return QM(e)?e:Oi(e)}function Oi(e){if(e==null||ci(e))return e;if(tw(e))return sg(e);if(kM(e))switch(e.type){case"FeatureCollection":return e.features;case"GeometryCollection":return e.geometries;default:return[e]}return Array.from(e)}function kM(e){switch(e?.type){case"FeatureCollection":case"GeometryCollection":case"Feature":case"LineString":case"MultiLineString":case"MultiPoint":case"MultiPolygon":case"Point":case"Polygon":case"Sphere":return!0;default:return!1}}function ue(e,t,n=Array){return e==null?e:e instanceof n?e.map(t):n.from(e,t)}function Vr(e,t=Array){return e instanceof t?e.slice():t.from(e)}function zM({x:e,x1:t,x2:n}){return e!==void 0||t!==void 0||n!==void 0}function fg({y:e,y1:t,y2:n}){return e!==void 0||t!==void 0||n!==void 0}function hg(e){return zM(e)||fg(e)||e.interval!==void 0}function ui(e){return e?.toString===OP}function Wo(e){return ui(e)&&(e.type!==void 0||e.domain!==void 0)}function $o(e){return ui(e)&&typeof e.transform!="function"}function Hr(e){return $o(e)&&e.value===void 0&&e.channel===void 0}function VM(e,t,n,i=fe){return t===void 0&&n===void 0?(t=0,n=e===void 0?i:e):t===void 0?t=e===void 0?0:e:n===void 0&&(n=e===void 0?0:e),[t,n]}function Zn(e,t){return e===void 0&&t===void 0?[Iu,Pc]:[e,t]}function Xo({z:e,fill:t,stroke:n}={}){return e===void 0&&([e]=ln(t)),e===void 0&&([e]=ln(n)),e}function Gr(e){return ci(e)?e.length:e?.numRows}function fn(e){let t=Gr(e),n=new Uint32Array(t);for(let i=0;i<t;++i)n[i]=i;return n}function Pu(e,t){return ci(e)?ue(t,n=>e[n],e.constructor):ue(t,n=>e.at(n))}function HM(e,t,n){return e.subarray?e.subarray(t,n):e.slice(t,n)}function Jn(e){return e!==null&&typeof e=="object"?e.valueOf():e}function GM(e,t){if(t[e]!==void 0)return t[e];switch(e){case"x1":case"x2":e="x";break;case"y1":case"y2":e="y";break}return t[e]}function Yo(e){let t;return[{transform:()=>t,label:fi(e)},n=>t=n]}function Kn(e){return e==null?[e]:Yo(e)}function fi(e,t){return typeof e=="string"?e:e&&e.label!==void 0?e.label:t}function Lc(e,t){return{transform(n){let i=e.transform(n),r=t.transform(n);return Re(i)||Re(r)?ue(i,(s,o)=>new Date((+i[o]+ +r[o])/2)):ue(i,(s,o)=>(+i[o]+ +r[o])/2,Float64Array)},label:e.label}}function Nc(e,t){let n=dg(t?.interval,t?.type);return n?ue(e,n):e}function dg(e,t){let n=Lu(e,t);return n&&(i=>qn(i)?n.floor(i):i)}function Lu(e,t){if(e!=null){if(typeof e=="number")return VP(e);if(typeof e=="string")return(t==="time"?tg:Ic)(e);if(typeof e.floor!="function")throw new Error("invalid interval; missing floor method");if(typeof e.offset!="function")throw new Error("invalid interval; missing offset method");return e}}function VP(e){e=+e,0<e&&e<1&&Number.isInteger(1/e)&&(e=-1/e);let t=Math.abs(e);return e<0?{floor:n=>Math.floor(n*t)/t,offset:(n,i=1)=>(n*t+Math.floor(i))/t,range:(n,i)=>bo(Math.ceil(n*t),i*t).map(r=>r/t)}:{floor:n=>Math.floor(n/t)*t,offset:(n,i=1)=>n+t*Math.floor(i),range:(n,i)=>bo(Math.ceil(n/t),i/t).map(r=>r*t)}}function Bi(e,t){if(e=Lu(e,t),e&&typeof e.range!="function")throw new Error("invalid interval: missing range method");return e}function WM(e,t){if(e=Bi(e,t),e&&typeof e.ceil!="function")throw new Error("invalid interval: missing ceil method");return e}function $M(e){return Wr(e)&&typeof e?.floor=="function"&&e.floor()instanceof Date}function Wr(e){return typeof e?.range=="function"}function ki(e){return e===void 0||$o(e)?e:{value:e}}function XM(e){return e==null?null:{transform:t=>ve(t,e,Float64Array),label:fi(e)}}function xn(e){return e&&typeof e[Symbol.iterator]=="function"}function Nu(e){for(let t of e)if(t!=null)return typeof t!="object"||t instanceof Date}function pg(e){for(let t of e){if(t==null)continue;let n=typeof t;return n==="string"||n==="boolean"}}function Re(e){for(let t of e)if(t!=null)return t instanceof Date}function YM(e){for(let t of e)if(t!=null)return typeof t=="string"&&isNaN(t)&&Cc(t)}function qM(e){for(let t of e)if(t!=null){if(typeof t!="string")return!1;if(t.trim())return!isNaN(t)}}function ZM(e){for(let t of e)if(t!=null)return typeof t=="number"}function Du(e,t){let n;for(let i of e)if(i!=null){if(!t(i))return!1;n=!0}return n}var HP=new Set("none,currentcolor,transparent,aliceblue,antiquewhite,aqua,aquamarine,azure,beige,bisque,black,blanchedalmond,blue,blueviolet,brown,burlywood,cadetblue,chartreuse,chocolate,coral,cornflowerblue,cornsilk,crimson,cyan,darkblue,darkcyan,darkgoldenrod,darkgray,darkgreen,darkgrey,darkkhaki,darkmagenta,darkolivegreen,darkorange,darkorchid,darkred,darksalmon,darkseagreen,darkslateblue,darkslategray,darkslategrey,darkturquoise,darkviolet,deeppink,deepskyblue,dimgray,dimgrey,dodgerblue,firebrick,floralwhite,forestgreen,fuchsia,gainsboro,ghostwhite,gold,goldenrod,gray,green,greenyellow,grey,honeydew,hotpink,indianred,indigo,ivory,khaki,lavender,lavenderblush,lawngreen,lemonchiffon,lightblue,lightcoral,lightcyan,lightgoldenrodyellow,lightgray,lightgreen,lightgrey,lightpink,lightsalmon,lightseagreen,lightskyblue,lightslategray,lightslategrey,lightsteelblue,lightyellow,lime,limegreen,linen,magenta,maroon,mediumaquamarine,mediumblue,mediumorchid,mediumpurple,mediumseagreen,mediumslateblue,mediumspringgreen,mediumturquoise,mediumvioletred,midnightblue,mintcream,mistyrose,moccasin,navajowhite,navy,oldlace,olive,olivedrab,orange,orangered,orchid,palegoldenrod,palegreen,paleturquoise,palevioletred,papayawhip,peachpuff,peru,pink,plum,powderblue,purple,rebeccapurple,red,rosybrown,royalblue,saddlebrown,salmon,sandybrown,seagreen,seashell,sienna,silver,skyblue,slateblue,slategray,slategrey,snow,springgreen,steelblue,tan,teal,thistle,tomato,turquoise,violet,wheat,white,whitesmoke,yellow".split(","));function qo(e){return typeof e!="string"?!1:(e=e.toLowerCase().trim(),/^#[0-9a-f]{3,8}$/.test(e)||/^(?:url|var|rgb|rgba|hsl|hsla|hwb|lab|lch|oklab|oklch|color|color-mix)\(.*\)$/.test(e)||HP.has(e))}function JM(e){return typeof e=="number"&&(0<=e&&e<=1||isNaN(e))}function Xe(e){return e==null||ks(e)}function ks(e){return/^\s*none\s*$/i.test(e)}function KM(e){return/^\s*round\s*$/i.test(e)}function Uu(e,t){return ug(e,t,["middle","top-left","top","top-right","right","bottom-right","bottom","bottom-left","left"])}function $r(e="middle"){return Uu(e,"frameAnchor")}function jM(e={},...t){let n=e;for(let i of t)for(let r in i)if(n[r]===void 0){let s=i[r];n===e?n={...n,[r]:s}:n[r]=s}return n}function GP(e){console.warn("named iterables are deprecated; please use an object instead");let t=new Set;return Object.fromEntries(Array.from(e,n=>{let{name:i}=n;if(i==null)throw new Error("missing name");let r=`${i}`;if(r==="__proto__")throw new Error(`illegal name: ${r}`);if(t.has(r))throw new Error(`duplicate name: ${r}`);return t.add(r),[i,n]}))}function mg(e){return xn(e)?GP(e):e}function Fu(e){return e===!0?e="frame":e===!1?e=null:!kM(e)&&e!=null&&(e=un(e,"clip",["frame","sphere"]),e==="sphere"&&(e={type:"Sphere"})),e}function QM(e){return e&&typeof e.getChild=="function"&&typeof e.toArray=="function"&&e.schema&&Array.isArray(e.schema.fields)}function tw(e){return e&&typeof e.toArray=="function"&&e.type}function WP(e){return e&&(e.typeId===8||e.typeId===10)&&e.unit===1}var jn=Symbol("position"),Cn=Symbol("color"),zs=Symbol("radius"),Vs=Symbol("length"),Hs=Symbol("opacity"),Zo=Symbol("symbol"),ew=Symbol("projection"),he=new Map([["x",jn],["y",jn],["fx",jn],["fy",jn],["r",zs],["color",Cn],["opacity",Hs],["symbol",Zo],["length",Vs],["projection",ew]]);function nw(e){return e===jn||e===ew}function iw(e){return e===jn||e===zs||e===Vs||e===Hs}var $P=Math.sqrt(3),XP=2/$P,YP={draw(e,t){let n=Math.sqrt(t/Math.PI),i=n*XP,r=i/2;e.moveTo(0,i),e.lineTo(n,r),e.lineTo(n,-r),e.lineTo(0,-i),e.lineTo(-n,-r),e.lineTo(-n,r),e.closePath()}},gg=new Map([["asterisk",Dm],["circle",Us],["cross",Um],["diamond",Fm],["diamond2",Om],["hexagon",YP],["plus",Bm],["square",km],["square2",zm],["star",Vm],["times",$m],["triangle",Hm],["triangle2",Gm],["wye",Wm]]);function yg(e){return e&&typeof e.draw=="function"}function rw(e){return yg(e)?!0:typeof e!="string"?!1:gg.has(e.toLowerCase())}function Jo(e){if(e==null||yg(e))return e;let t=gg.get(`${e}`.toLowerCase());if(t)return t;throw new Error(`invalid symbol: ${e}`)}function sw(e){if(e==null||yg(e))return[void 0,e];if(typeof e=="string"){let t=gg.get(`${e}`.toLowerCase());if(t)return[void 0,t]}return[e,void 0]}function Gs({filter:e,sort:t,reverse:n,transform:i,initializer:r,...s}={},o){if(i===void 0&&(e!=null&&(i=ow(e)),t!=null&&!Hr(t)&&(i=xg(i,vg(t))),n&&(i=xg(i,aw))),o!=null&&r!=null)throw new Error("transforms cannot be applied after initializers");return{...s,...(t===null||Hr(t))&&{sort:t},transform:xg(i,o)}}function cr({filter:e,sort:t,reverse:n,initializer:i,...r}={},s){return i===void 0&&(e!=null&&(i=ow(e)),t!=null&&!Hr(t)&&(i=_g(i,vg(t))),n&&(i=_g(i,aw))),{...r,...(t===null||Hr(t))&&{sort:t},initializer:_g(i,s)}}function xg(e,t){return e==null?t===null?void 0:t:t==null?e===null?void 0:e:function(n,i,r){return{data:n,facets:i}=e.call(this,n,i,r),t.call(this,ar(n),i,r)}}function _g(e,t){return e==null?t===null?void 0:t:t==null?e===null?void 0:e:function(n,i,r,...s){let o,a,c,l,u,h;return{data:a=n,facets:c=i,channels:o}=e.call(this,n,i,r,...s),{data:u=a,facets:h=c,channels:l}=t.call(this,a,c,{...r,...o},...s),{data:u,facets:h,channels:{...o,...l}}}}function qP(e,t){return(e.initializer!=null?cr:Gs)(e,t)}function ow(e){return(t,n)=>{let i=ve(t,e);return{data:t,facets:n.map(r=>r.filter(s=>i[s]))}}}function aw(e,t){return{data:e,facets:t.map(n=>n.slice().reverse())}}function cw(e,{sort:t,...n}={}){return{...($o(e)&&e.channel!==void 0?cr:qP)(n,vg(e)),sort:Hr(t)?t:null}}function vg(e){return(typeof e=="function"&&e.length!==1?ZP:JP)(e)}function ZP(e){return(t,n)=>{let i=ci(t)?(r,s)=>e(t[r],t[s]):(r,s)=>e(t.get(r),t.get(s));return{data:t,facets:n.map(r=>r.slice().sort(i))}}}function JP(e){let t,n;({channel:t,value:e,order:n}={...ki(e)});let i=t?.startsWith("-");if(i&&(t=t.slice(1)),n===void 0&&(n=i?Fs:en),typeof n!="function")switch(`${n}`.toLowerCase()){case"ascending":n=en;break;case"descending":n=Fs;break;default:throw new Error(`invalid order: ${n}`)}return(r,s,o)=>{let a;if(t===void 0)a=ve(r,e);else{if(o===void 0)throw new Error("channel sort requires an initializer");if(a=o[t],!a)return{};a=a.value}let c=(l,u)=>n(a[l],a[u]);return{data:r,facets:s.map(l=>l.slice().sort(c))}}}function Uc(e,...t){for(let{name:n}of e)if(t.includes(n))return!0;return!1}function fw(e,t,n=bg){let i=Object.entries(e);return t.title!=null&&e.title===void 0&&i.push(["title",eL]),t.href!=null&&e.href===void 0&&i.push(["href",Ou]),i.filter(([,r])=>r!==void 0).map(([r,s])=>s===null?KP(r):n(r,s,t))}function bg(e,t,n,i=Mg){let r;ui(t)&&"reduce"in t&&(r=t.scale,t=t.reduce);let s=i(e,t,n),[o,a]=Yo(s.label),c;return{name:e,output:r===void 0?o:{value:o,scale:r},initialize(l){s.initialize(l),c=a([])},scope(l,u){s.scope(l,u)},reduce(l,u){c.push(s.reduce(l,u))}}}function KP(e){return{name:e,initialize(){},scope(){},reduce(){}}}function Mg(e,t,n,i=Fc){let r=GM(e,n),s=i(t,r),o,a;return{label:fi(s===Dc?null:r,s.label),initialize(c){o=r===void 0?c:ve(c,r),s.scope==="data"&&(a=s.reduceIndex(fn(c),o))},scope(c,l){s.scope===c&&(a=s.reduceIndex(l,o))},reduce(c,l){return s.scope==null?s.reduceIndex(c,o,l):s.reduceIndex(c,o,a,l)}}}function wg(e,t){return t?ms(e,n=>t[n]):[[,e]]}function Fc(e,t,n=jP){if(e==null)return n(e);if(typeof e.reduceIndex=="function")return e;if(typeof e.reduce=="function"&&ui(e))return QP(e);if(typeof e=="function")return tL(e);if(/^p\d{2}$/i.test(e))return lr(BM(e));switch(`${e}`.toLowerCase()){case"first":return Ou;case"last":return nL;case"identity":return Sg;case"count":return Dc;case"distinct":return iL;case"sum":return t==null?Dc:rL;case"proportion":return uw(t,"data");case"proportion-facet":return uw(t,"facet");case"deviation":return lr(Kh);case"min":return lr(Bn);case"min-index":return lr(b_);case"max":return lr(sn);case"max-index":return lr(v_);case"mean":return lw(T_);case"median":return lw(Za);case"variance":return lr(Jh);case"mode":return lr(E_)}return n(e)}function jP(e){throw new Error(`invalid reduce: ${e}`)}function hw(e,t){for(let n in t){let i=t[n];if(i!==void 0&&!e.some(r=>r.name===n))return i}}function dw(e,t,n){if(t){let i=t.output.transform(),r=(s,o)=>en(i[s],i[o]);e.forEach(s=>s.sort(r))}n&&e.forEach(i=>i.reverse())}function QP(e){return console.warn("deprecated reduce interface; implement reduceIndex instead."),{...e,reduceIndex:e.reduce.bind(e)}}function tL(e){return{reduceIndex(t,n,i){return e(Pu(n,t),i)}}}function lr(e){return{reduceIndex(t,n){return e(t,i=>n[i])}}}function lw(e){return{reduceIndex(t,n){let i=e(t,r=>n[r]);return Re(n)?new Date(i):i}}}var Sg={reduceIndex(e,t){return Pu(t,e)}},Ou={reduceIndex(e,t){return t[e[0]]}},eL={reduceIndex(e,t){let i=yo(Ji(e,s=>s.length,s=>t[s]),Pc),r=i.slice(-5).reverse();if(r.length<i.length){let s=i.slice(0,-4);r[4]=[`… ${s.length.toLocaleString("en-US")} more`,ri(s,Pc)]}return r.map(([s,o])=>`${s} (${o.toLocaleString("en-US")})`).join(`
`)}},nL={reduceIndex(e,t){return t[e[e.length-1]]}},Dc={label:"Frequency",reduceIndex(e){return e.length}},iL={label:"Distinct",reduceIndex(e,t){let n=new Mi;for(let i of e)n.add(t[i]);return n.size}},rL=lr(ri);function uw(e,t){return e==null?{scope:t,label:"Frequency",reduceIndex:(n,i,r=1)=>n.length/r}:{scope:t,reduceIndex:(n,i,r=1)=>ri(n,s=>i[s])/r}}var pw={reduceIndex(e,t,{z:n}){return n}};function Ko(e,{scale:t,type:n,value:i,filter:r,hint:s,label:o=fi(i)},a){return s===void 0&&typeof i?.transform=="function"&&(s=i.hint),Eg(a,{scale:t,type:n,value:ve(e,i),label:o,filter:r,hint:s})}function gw(e,t){return Object.fromEntries(Object.entries(e).map(([n,i])=>[n,Ko(t,i,n)]))}function yw(e,t){let n=Object.fromEntries(Object.entries(e).map(([i,{scale:r,value:s}])=>{let o=r==null?null:t[r];return[i,o==null?s:ue(s,o)]}));return n.channels=e,n}function Eg(e,t){let{scale:n,value:i}=t;if(n===!0||n==="auto")switch(e){case"fill":case"stroke":case"color":t.scale=n!==!0&&Du(i,qo)?null:"color",t.defaultScale="color";break;case"fillOpacity":case"strokeOpacity":case"opacity":t.scale=n!==!0&&Du(i,JM)?null:"opacity",t.defaultScale="opacity";break;case"symbol":n!==!0&&Du(i,rw)?(t.scale=null,t.value=ue(i,Jo)):t.scale="symbol",t.defaultScale="symbol";break;default:t.scale=he.has(e)?e:null;break}else if(n===!1)t.scale=null;else if(n!=null&&!he.has(n))throw new Error(`unknown scale: ${n}`);return t}function xw(e,t,n,i,r){let{order:s,reverse:o,reduce:a=!0,limit:c}=r;for(let l in r){if(!he.has(l))continue;let{value:u,order:h=s,reverse:f=o,reduce:d=a,limit:m=c}=ki(r[l]),y=u?.startsWith("-");if(y&&(u=u.slice(1)),h=h===void 0?y!==(u==="width"||u==="height")?vw:_w:aL(h),d==null||d===!1)continue;let g=l==="fx"||l==="fy"?oL(t,i[l]):sL(n,l);if(!g)throw new Error(`missing channel for scale: ${l}`);let p=g.value,[_=0,b=1/0]=xn(m)?m:m<0?[m]:[0,m];if(u==null)g.domain=()=>{let x=Array.from(new Mi(p));return f&&(x=x.reverse()),(_!==0||b!==1/0)&&(x=x.slice(_,b)),x};else{let x=u==="data"?e:u==="height"?mw(n,"y1","y2"):u==="width"?mw(n,"x1","x2"):Tg(n,u,u==="y"?"y2":u==="x"?"x2":void 0),C=Fc(d===!0?"max":d,x);g.domain=()=>{let w=y_(fn(p),S=>C.reduceIndex(S,x),S=>p[S]);return h&&w.sort(h),f&&w.reverse(),(_!==0||b!==1/0)&&(w=w.slice(_,b)),w.map(Iu)}}}}function sL(e,t){for(let n in e){let i=e[n];if(i.scale===t)return i}}function oL(e,t){let n=e.original;if(n===e)return t;let i=t.value,r=t.value=[];for(let s=0;s<n.length;++s){let o=i[n[s][0]];for(let a of e[s])r[a]=o}return t}function mw(e,t,n){let i=Tg(e,t),r=Tg(e,n);return ue(r,(s,o)=>Math.abs(s-i[o]),Float64Array)}function Tg(e,t,n){let i=e[t];if(!i&&n!==void 0&&(i=e[n]),i)return i.value;throw new Error(`missing channel: ${t}`)}function aL(e){if(e==null||typeof e=="function")return e;switch(`${e}`.toLowerCase()){case"ascending":return _w;case"descending":return vw}throw new Error(`invalid order: ${e}`)}function _w([e,t],[n,i]){return en(t,i)||en(e,n)}function vw([e,t],[n,i]){return Fs(t,i)||en(e,n)}function Ag(e,t){let n=e[t];if(n){for(;n.source;)n=n.source;return n.source===null?null:n}}var Tw=new Map([["accent",T1],["category10",S1],["dark2",E1],["observable10",A1],["paired",C1],["pastel1",R1],["pastel2",I1],["set1",P1],["set2",L1],["set3",N1],["tableau10",D1]]);function Ew(e){return e!=null&&Tw.has(`${e}`.toLowerCase())}var bw=new Map([...Tw,["brbg",ur(Mp,wp)],["prgn",ur(Sp,Tp)],["piyg",ur(Ep,Ap)],["puor",ur(Cp,Rp)],["rdbu",ur(gu,Sc)],["rdgy",ur(Ip,Pp)],["rdylbu",ur(yu,Tc)],["rdylgn",ur(Lp,Np)],["spectral",ur(Dp,Up)],["burd",Mw(gu,Sc)],["buylrd",Mw(yu,Tc)],["blues",Ye(om,am)],["greens",Ye(cm,lm)],["greys",Ye(um,fm)],["oranges",Ye(gm,ym)],["purples",Ye(hm,dm)],["reds",Ye(pm,mm)],["turbo",fr(Sm)],["viridis",fr(Tm)],["magma",fr(Em)],["inferno",fr(Am)],["plasma",fr(Cm)],["cividis",fr(xm)],["cubehelix",fr(_m)],["warm",fr(vm)],["cool",fr(bm)],["bugn",Ye(Fp,Op)],["bupu",Ye(Bp,kp)],["gnbu",Ye(zp,Vp)],["orrd",Ye(Hp,Gp)],["pubu",Ye(Xp,Yp)],["pubugn",Ye(Wp,$p)],["purd",Ye(qp,Zp)],["rdpu",Ye(Jp,Kp)],["ylgn",Ye(tm,em)],["ylgnbu",Ye(jp,Qp)],["ylorbr",Ye(nm,im)],["ylorrd",Ye(rm,sm)],["rainbow",ww(Mm)],["sinebow",ww(wm)]]);function Ye(e,t){return({length:n})=>n===1?[e[3][1]]:n===2?[e[3][1],e[3][2]]:(n=Math.max(3,Math.floor(n)),n>9?on(t,n):e[n])}function ur(e,t){return({length:n})=>n===2?[e[3][0],e[3][2]]:(n=Math.max(3,Math.floor(n)),n>11?on(t,n):e[n])}function Mw(e,t){return({length:n})=>n===2?[e[3][2],e[3][0]]:(n=Math.max(3,Math.floor(n)),n>11?on(i=>t(1-i),n):e[n].slice().reverse())}function fr(e){return({length:t})=>on(e,Math.max(2,Math.floor(t)))}function ww(e){return({length:t})=>on(e,Math.floor(t)+1).slice(0,-1)}function Cg(e){let t=`${e}`.toLowerCase();if(!bw.has(t))throw new Error(`unknown ordinal scheme: ${t}`);return bw.get(t)}function Oc(e,t){let n=Cg(e),i=typeof n=="function"?n({length:t}):n;return i.length!==t?i.slice(0,t):i}function Aw(e,t="greys"){let n=new Set,[i,r]=Oc(t,2);for(let s of e)if(s!=null)if(s===!0)n.add(r);else if(s===!1)n.add(i);else return;return[...n]}var Sw=new Map([["brbg",wp],["prgn",Tp],["piyg",Ap],["puor",Rp],["rdbu",Sc],["rdgy",Pp],["rdylbu",Tc],["rdylgn",Np],["spectral",Up],["burd",e=>Sc(1-e)],["buylrd",e=>Tc(1-e)],["blues",am],["greens",lm],["greys",fm],["purples",dm],["reds",mm],["oranges",ym],["turbo",Sm],["viridis",Tm],["magma",Em],["inferno",Am],["plasma",Cm],["cividis",xm],["cubehelix",_m],["warm",vm],["cool",bm],["bugn",Op],["bupu",kp],["gnbu",Vp],["orrd",Gp],["pubugn",$p],["pubu",Yp],["purd",Zp],["rdpu",Kp],["ylgnbu",Qp],["ylgn",em],["ylorbr",im],["ylorrd",sm],["rainbow",Mm],["sinebow",wm]]);function jo(e){let t=`${e}`.toLowerCase();if(!Sw.has(t))throw new Error(`unknown quantitative scheme: ${t}`);return Sw.get(t)}var cL=new Set(["brbg","prgn","piyg","puor","rdbu","rdgy","rdylbu","rdylgn","spectral","burd","buylrd"]);function Cw(e){return e!=null&&cL.has(`${e}`.toLowerCase())}var Ig=e=>t=>e(1-t),Rg=[0,1],Rw=new Map([["number",Oe],["rgb",vs],["hsl",_v],["hcl",Mv],["lab",vv]]);function Pg(e){let t=`${e}`.toLowerCase();if(!Rw.has(t))throw new Error(`unknown interpolator: ${t}`);return Rw.get(t)}function ta(e,t,n,{type:i,nice:r,clamp:s,zero:o,domain:a=Bw(e,n),unknown:c,round:l,scheme:u,interval:h,range:f=he.get(e)===zs?hL(n,a):he.get(e)===Vs?dL(n,a):he.get(e)===Hs?Rg:void 0,interpolate:d=he.get(e)===Cn?u==null&&f!==void 0?vs:jo(u!==void 0?u:i==="cyclical"?"rainbow":"turbo"):l?Qa:Oe,reverse:m}){if(a=Iw(a),h=Bi(h,i),(i==="cyclical"||i==="sequential")&&(i="linear"),typeof d!="function"&&(d=Pg(d)),m=!!m,f!==void 0){let y=a.length,g=(f=Iw(f)).length;if(y!==g){if(d.length===1)throw new Error("invalid piecewise interpolator");d=Dr(d,f),f=void 0}}if(d.length===1?(m&&(d=Ig(d),m=!1),f===void 0&&(f=Float64Array.from(a,(y,g)=>g/(a.length-1)),f.length===2&&(f=Rg)),t.interpolate((f===Rg?An:Bc)(d))):t.interpolate(d),o){let[y,g]=Je(a);(y>0||g<0)&&(a=Vr(a),(or(a)||1)===Math.sign(y)?a[0]=0:a[a.length-1]=0)}return m&&(a=Mo(a)),t.domain(a).unknown(c),r&&(t.nice(lL(r,i)),a=t.domain()),f!==void 0&&t.range(f),s&&t.clamp(s),{type:i,domain:a,range:f,scale:t,interpolate:d,interval:h}}function Iw(e){return e=Oi(e),e.length>=2?e:[e[0],e[0]]}function lL(e,t){return e===!0?void 0:typeof e=="number"?e:WM(e,t)}function Pw(e,t,n){return ta(e,wc(),t,n)}function Lw(e,t,n){return Lg(e,t,{...n,exponent:.5})}function Lg(e,t,{exponent:n=1,...i}){return ta(e,pp().exponent(n),t,{...i,type:"pow"})}function Nw(e,t,{base:n=10,domain:i=pL(t),...r}){return ta(e,hp().base(n),t,{...r,domain:i})}function Dw(e,t,{constant:n=1,...i}){return ta(e,dp().constant(n),t,i)}function Uw(e,t,{range:n,quantiles:i=n===void 0?5:(n=[...n]).length,n:r=i,scheme:s="rdylbu",domain:o=mL(t),unknown:a,interpolate:c,reverse:l}){return n===void 0&&(n=c!==void 0?on(c,r):he.get(e)===Cn?Oc(s,r):void 0),o.length>0&&(o=mp(o,n===void 0?{length:r}:n).quantiles()),Bu(e,t,{domain:o,range:n,reverse:l,unknown:a})}function Fw(e,t,{range:n,n:i=n===void 0?5:(n=[...n]).length,scheme:r="rdylbu",domain:s=Bw(e,t),unknown:o,interpolate:a,reverse:c}){let[l,u]=Je(s),h;return n===void 0?(h=Pr(l,u,i),h[0]<=l&&h.splice(0,1),h[h.length-1]>=u&&h.pop(),i=h.length+1,n=a!==void 0?on(a,i):he.get(e)===Cn?Oc(r,i):void 0):(h=on(Oe(l,u),i+1).slice(1,-1),l instanceof Date&&(h=h.map(f=>new Date(f)))),or(Oi(s))<0&&h.reverse(),Bu(e,t,{domain:h,range:n,reverse:c,unknown:o})}function Bu(e,t,{domain:n=[0],unknown:i,scheme:r="rdylbu",interpolate:s,range:o=s!==void 0?on(s,n.length+1):he.get(e)===Cn?Oc(r,n.length+1):void 0,reverse:a}){n=Oi(n);let c=or(n);if(!isNaN(c)&&!uL(n,c))throw new Error(`the ${e} scale has a non-monotonic domain`);return a&&(o=Mo(o)),{type:"threshold",scale:gp(c<0?Mo(n):n,o===void 0?[]:o).unknown(i),domain:n,range:o}}function uL(e,t){for(let n=1,i=e.length,r=e[0];n<i;++n){let s=Zi(r,r=e[n]);if(s!==0&&s!==t)return!1}return!0}function Ow(e){return{type:"identity",scale:iw(he.get(e))?fp():t=>t}}function Qo(e,t=Jm){return e.length?[Bn(e,({value:n})=>n===void 0?n:Bn(n,t)),sn(e,({value:n})=>n===void 0?n:sn(n,t))]:[0,1]}function Bw(e,t){let n=he.get(e);return(n===zs||n===Hs||n===Vs?fL:Qo)(t)}function fL(e){return[0,e.length?sn(e,({value:t})=>t===void 0?t:sn(t,Jm)):1]}function hL(e,t){let n=e.find(({radius:o})=>o!==void 0);if(n!==void 0)return[0,n.radius];let i=qi(e,.5,({value:o})=>o===void 0?NaN:qi(o,.25,Os)),r=t.map(o=>3*Math.sqrt(o/i)),s=30/sn(r);return s<1?r.map(o=>o*s):r}function dL(e,t){let n=Za(e,({value:s})=>s===void 0?NaN:Za(s,Math.abs)),i=t.map(s=>12*s/n),r=60/sn(i);return r<1?i.map(s=>s*r):i}function pL(e){for(let{value:t}of e)if(t!==void 0)for(let n of t){if(n>0)return Qo(e,Os);if(n<0)return Qo(e,ko)}return[1,10]}function mL(e){let t=[];for(let{value:n}of e)if(n!==void 0)for(let i of n)t.push(i);return t}function Bc(e){return(t,n)=>i=>e(t+i*(n-t))}var Ng=0,Dg;function kw(){let e=Ng;return Ng=0,Dg=void 0,e}function _n(e){e!==Dg&&(Dg=e,console.warn(e),++Ng)}function ku(e,t,n,i,{type:r,nice:s,clamp:o,domain:a=Qo(i),unknown:c,pivot:l=0,scheme:u,range:h,symmetric:f=!0,interpolate:d=he.get(e)===Cn?u==null&&h!==void 0?vs:jo(u!==void 0?u:"rdbu"):Oe,reverse:m}){l=+l,a=Oi(a);let[y,g]=a;if(a.length>2&&_n(`Warning: the diverging ${e} scale domain contains extra elements.`),Zi(y,g)<0&&([y,g]=[g,y],m=!m),y=Math.min(y,l),g=Math.max(g,l),typeof d!="function"&&(d=Pg(d)),h!==void 0&&(d=d.length===1?Bc(d)(...h):Dr(d,h)),m&&(d=Ig(d)),f){let p=n.apply(l),_=p-n.apply(y),b=n.apply(g)-p;_<b?y=n.invert(p-b):_>b&&(g=n.invert(p+_))}return t.domain([y,l,g]).unknown(c).interpolator(d),o&&t.clamp(o),s&&t.nice(s),{type:r,domain:[y,g],pivot:l,interpolate:d,scale:t}}function zw(e,t,n){return ku(e,xp(),gL,t,n)}function Vw(e,t,n){return Ug(e,t,{...n,exponent:.5})}function Ug(e,t,{exponent:n=1,...i}){return ku(e,bp().exponent(n=+n),_L(n),t,{...i,type:"diverging-pow"})}function Hw(e,t,{base:n=10,pivot:i=1,domain:r=Qo(t,i<0?ko:Os),...s}){return ku(e,_p().base(n=+n),yL,t,{domain:r,pivot:i,...s})}function Gw(e,t,{constant:n=1,...i}){return ku(e,vp().constant(n=+n),vL(n),t,i)}var gL={apply(e){return e},invert(e){return e}},yL={apply:Math.log,invert:Math.exp},xL={apply(e){return Math.sign(e)*Math.sqrt(Math.abs(e))},invert(e){return Math.sign(e)*(e*e)}};function _L(e){return e===.5?xL:{apply(t){return Math.sign(t)*Math.pow(Math.abs(t),e)},invert(t){return Math.sign(t)*Math.pow(Math.abs(t),1/e)}}}function vL(e){return{apply(t){return Math.sign(t)*Math.log1p(Math.abs(t/e))},invert(t){return Math.sign(t)*Math.expm1(Math.abs(t))*e}}}function Ww(e,t,n,i){return ta(e,t,n,i)}function $w(e,t,n){return Ww(e,M1(),t,n)}function Xw(e,t,n){return Ww(e,w1(),t,n)}var ea=Symbol("ordinal");function qw(e,t,n,{type:i,interval:r,domain:s,range:o,reverse:a,hint:c}){return r=Bi(r,i),s===void 0&&(s=Qw(n,r,e)),(i==="categorical"||i===ea)&&(i="ordinal"),a&&(s=Mo(s)),s=t.domain(s).domain(),o!==void 0&&(typeof o=="function"&&(o=o(s)),t.range(o)),{type:i,domain:s,range:o,scale:t,hint:c,interval:r}}function Zw(e,t,{type:n,interval:i,domain:r,range:s,scheme:o,unknown:a,...c}){i=Bi(i,n),r===void 0&&(r=Qw(t,i,e));let l;if(he.get(e)===Zo)l=bL(t),s=s===void 0?ML(l):ue(s,Jo);else if(he.get(e)===Cn&&(s===void 0&&(n==="ordinal"||n===ea)&&(s=Aw(r,o),s!==void 0&&(o=void 0)),o===void 0&&s===void 0&&(o=n==="ordinal"?"turbo":"observable10"),o!==void 0))if(s!==void 0){let u=jo(o),h=s[0],f=s[1]-s[0];s=({length:d})=>on(m=>u(h+f*m),d)}else s=Cg(o);if(a===cu)throw new Error(`implicit unknown on ${e} scale is not supported`);return qw(e,uu().unknown(a),t,{...c,type:n,domain:r,range:s,hint:l})}function Jw(e,t,{align:n=.5,padding:i=.5,...r}){return jw(g1().align(n).padding(i),t,r,e)}function Kw(e,t,{align:n=.5,padding:i=.1,paddingInner:r=i,paddingOuter:s=e==="fx"||e==="fy"?0:i,...o}){return jw(Bo().align(n).paddingInner(r).paddingOuter(s),t,o,e)}function jw(e,t,n,i){let{round:r}=n;return r!==void 0&&e.round(r=!!r),e=qw(i,e,t,n),e.round=r,e}function Qw(e,t,n){let i=new Mi;for(let{value:r,domain:s}of e){if(s!==void 0)return s();if(r!==void 0)for(let o of r)i.add(o)}if(t!==void 0){let[r,s]=Je(i).map(t.floor,t);return t.range(r,t.offset(s))}if(i.size>1e4&&he.get(n)===jn)throw new Error(`implicit ordinal domain of ${n} scale has more than 10,000 values`);return yo(i,en)}function Yw(e,t){let n;for(let{hint:i}of e){let r=i?.[t];if(r!==void 0){if(n===void 0)n=r;else if(n!==r)return}}return n}function bL(e){return{fill:Yw(e,"fill"),stroke:Yw(e,"stroke")}}function ML(e){return Xe(e.fill)?Q1:j1}function kc(e,{label:t,inset:n=0,insetTop:i=n,insetRight:r=n,insetBottom:s=n,insetLeft:o=n,round:a,nice:c,clamp:l,zero:u,align:h,padding:f,projection:d,facet:{label:m=t}={},...y}={}){let g={};for(let[p,_]of e){let b=y[p],x=TL(p,_,{round:he.get(p)===jn?a:void 0,nice:c,clamp:l,zero:u,align:h,padding:f,projection:d,...b});if(x){let{label:C=p==="fx"||p==="fy"?m:t,percent:w,transform:S,inset:R,insetTop:M=R!==void 0?R:p==="y"?i:0,insetRight:v=R!==void 0?R:p==="x"?r:0,insetBottom:E=R!==void 0?R:p==="y"?s:0,insetLeft:N=R!==void 0?R:p==="x"?o:0}=b||{};if(S==null)S=void 0;else if(typeof S!="function")throw new Error("invalid scale transform; not a function");x.percent=!!w,x.label=C===void 0?wL(_,x):C,x.transform=S,p==="x"||p==="fx"?(x.insetLeft=+N,x.insetRight=+v):(p==="y"||p==="fy")&&(x.insetTop=+M,x.insetBottom=+E),g[p]=x}}return g}function Og(e){let t={},n={scales:t};for(let[i,r]of Object.entries(e)){let{scale:s,type:o,interval:a,label:c}=r;t[i]=RL(r),n[i]=s,s.type=o,a!=null&&(s.interval=a),c!=null&&(s.label=c)}return n}function rS(e,t){let{x:n,y:i,fx:r,fy:s}=e,o=r||s?Vu(t):t;r&&tS(r,o),s&&eS(s,o);let a=r||s?Bg(e,t):t;n&&tS(n,a),i&&eS(i,a)}function wL(e=[],t){let n;for(let{label:i}of e)if(i!==void 0){if(n===void 0)n=i;else if(n!==i)return}if(n!==void 0)return!zi(t)&&t.percent&&(n=`${n} (%)`),{inferred:!0,toString:()=>n}}function sS(e){return Math.sign(or(e.domain()))*Math.sign(or(e.range()))}function Vu(e){let{marginTop:t,marginRight:n,marginBottom:i,marginLeft:r,width:s,height:o,facet:{marginTop:a,marginRight:c,marginBottom:l,marginLeft:u}}=e;return{marginTop:Math.max(t,a),marginRight:Math.max(n,c),marginBottom:Math.max(i,l),marginLeft:Math.max(r,u),width:s,height:o}}function Bg({fx:e,fy:t},n){let{marginTop:i,marginRight:r,marginBottom:s,marginLeft:o,width:a,height:c}=Vu(n);return{marginTop:i,marginRight:r,marginBottom:s,marginLeft:o,width:e?e.scale.bandwidth()+o+r:a,height:t?t.scale.bandwidth()+i+s:c,facet:{width:a,height:c}}}function tS(e,t){if(e.range===void 0){let{insetLeft:n,insetRight:i}=e,{width:r,marginLeft:s=0,marginRight:o=0}=t,a=s+n,c=r-o-i;e.range=[a,Math.max(a,c)],zi(e)||(e.range=aS(e)),e.scale.range(e.range)}oS(e)}function eS(e,t){if(e.range===void 0){let{insetTop:n,insetBottom:i}=e,{height:r,marginTop:s=0,marginBottom:o=0}=t,a=s+n,c=r-o-i;e.range=[Math.max(a,c),a],zi(e)?e.range.reverse():e.range=aS(e),e.scale.range(e.range)}oS(e)}function oS(e){e.round===void 0&&AL(e)&&SL(e)<=30&&e.scale.round(!0)}function SL({scale:e}){let t=e.domain().length,[n,i]=e.range(),r=e.paddingInner?e.paddingInner():1,s=e.paddingOuter?e.paddingOuter():e.padding(),o=t-r,a=Math.abs(i-n)/Math.max(1,o+s*2);return(a-Math.floor(a))*o}function aS(e){let t=e.scale.domain().length+kg(e);if(!(t>2))return e.range;let[n,i]=e.range;return Array.from({length:t},(r,s)=>n+s/(t-1)*(i-n))}function TL(e,t=[],n={}){let i=EL(e,t,n);if(n.type===void 0&&n.domain===void 0&&n.range===void 0&&n.interval==null&&e!=="fx"&&e!=="fy"&&zi({type:i})){let r=t.map(({value:s})=>s).filter(s=>s!==void 0);r.some(Re)?_n(`Warning: some data associated with the ${e} scale are dates. Dates are typically associated with a "utc" or "time" scale rather than a "${na(i)}" scale. If you are using a bar mark, you probably want a rect mark with the interval option instead; if you are using a group transform, you probably want a bin transform instead. If you want to treat this data as ordinal, you can specify the interval of the ${e} scale (e.g., d3.utcDay), or you can suppress this warning by setting the type of the ${e} scale to "${na(i)}".`):r.some(YM)?_n(`Warning: some data associated with the ${e} scale are strings that appear to be dates (e.g., YYYY-MM-DD). If these strings represent dates, you should parse them to Date objects. Dates are typically associated with a "utc" or "time" scale rather than a "${na(i)}" scale. If you are using a bar mark, you probably want a rect mark with the interval option instead; if you are using a group transform, you probably want a bin transform instead. If you want to treat this data as ordinal, you can suppress this warning by setting the type of the ${e} scale to "${na(i)}".`):r.some(qM)&&_n(`Warning: some data associated with the ${e} scale are strings that appear to be numbers. If these strings represent numbers, you should parse or coerce them to numbers. Numbers are typically associated with a "linear" scale rather than a "${na(i)}" scale. If you want to treat this data as ordinal, you can specify the interval of the ${e} scale (e.g., 1 for integers), or you can suppress this warning by setting the type of the ${e} scale to "${na(i)}".`)}switch(n.type=i,i){case"diverging":case"diverging-sqrt":case"diverging-pow":case"diverging-log":case"diverging-symlog":case"cyclical":case"sequential":case"linear":case"sqrt":case"threshold":case"quantile":case"pow":case"log":case"symlog":n=zu(t,n,Fi);break;case"identity":switch(he.get(e)){case jn:n=zu(t,n,Fi);break;case Zo:n=zu(t,n,CL);break}break;case"utc":case"time":n=zu(t,n,cg);break}switch(i){case"diverging":return zw(e,t,n);case"diverging-sqrt":return Vw(e,t,n);case"diverging-pow":return Ug(e,t,n);case"diverging-log":return Hw(e,t,n);case"diverging-symlog":return Gw(e,t,n);case"categorical":case"ordinal":case ea:return Zw(e,t,n);case"cyclical":case"sequential":case"linear":return Pw(e,t,n);case"sqrt":return Lw(e,t,n);case"threshold":return Bu(e,t,n);case"quantile":return Uw(e,t,n);case"quantize":return Fw(e,t,n);case"pow":return Lg(e,t,n);case"log":return Nw(e,t,n);case"symlog":return Dw(e,t,n);case"utc":return Xw(e,t,n);case"time":return $w(e,t,n);case"point":return Jw(e,t,n);case"band":return Kw(e,t,n);case"identity":return Ow(e);case void 0:return;default:throw new Error(`unknown scale type: ${i}`)}}function na(e){return typeof e=="symbol"?e.description:e}function nS(e){return typeof e=="string"?`${e}`.toLowerCase():e}var iS={toString:()=>"projection"};function EL(e,t,{type:n,domain:i,range:r,scheme:s,pivot:o,projection:a}){if(n=nS(n),e==="fx"||e==="fy")return"band";(e==="x"||e==="y")&&a!=null&&(n=iS);for(let u of t){let h=nS(u.type);if(h!==void 0){if(n===void 0)n=h;else if(n!==h)throw new Error(`scale incompatible with channel: ${n} !== ${h}`)}}if(n===iS)return;if(n!==void 0)return n;if(i===void 0&&!t.some(({value:u})=>u!==void 0))return;let c=he.get(e);if(c===zs)return"sqrt";if(c===Hs||c===Vs)return"linear";if(c===Zo)return"ordinal";let l=(i??r)?.length;if(l<2||l>2)return Fg(c);if(i!==void 0){if(pg(i))return Fg(c);if(Re(i))return"utc"}else{let u=t.map(({value:h})=>h).filter(h=>h!==void 0);if(u.some(pg))return Fg(c);if(u.some(Re))return"utc"}if(c===Cn){if(o!=null||Cw(s))return"diverging";if(Ew(s))return"categorical"}return"linear"}function Fg(e){switch(e){case jn:return"point";case Cn:return ea;default:return"ordinal"}}function zi({type:e}){return e==="ordinal"||e==="point"||e==="band"||e===ea}function kg({type:e}){return e==="threshold"}function AL({type:e}){return e==="point"||e==="band"}function hi(e){if(e===void 0)return!0;let t=e.domain(),n=e(t[0]);for(let i=1,r=t.length;i<r;++i)if(e(t[i])-n)return!1;return!0}function zu(e,{domain:t,...n},i){for(let r of e)r.value!==void 0&&(t===void 0&&(t=r.value?.domain),r.value=i(r.value));return{domain:t===void 0?t:i(t),...n}}function CL(e){return ue(e,Jo)}function cS(e){return t=>{if(!he.has(t=`${t}`))throw new Error(`unknown scale: ${t}`);return e[t]}}function RL({scale:e,type:t,domain:n,range:i,interpolate:r,interval:s,transform:o,percent:a,pivot:c}){if(t==="identity")return{type:"identity",apply:u=>u,invert:u=>u};let l=e.unknown?e.unknown():void 0;return{type:t,domain:Vr(n),...i!==void 0&&{range:Vr(i)},...o!==void 0&&{transform:o},...a&&{percent:a},...l!==void 0&&{unknown:l},...s!==void 0&&{interval:s},...r!==void 0&&{interpolate:r},...e.clamp&&{clamp:e.clamp()},...c!==void 0&&{pivot:c,symmetric:!1},...e.base&&{base:e.base()},...e.exponent&&{exponent:e.exponent()},...e.constant&&{constant:e.constant()},...e.align&&{align:e.align(),round:e.round()},...e.padding&&(e.paddingInner?{paddingInner:e.paddingInner(),paddingOuter:e.paddingOuter()}:{padding:e.padding()}),...e.bandwidth&&{bandwidth:e.bandwidth(),step:e.step()},apply:u=>e(u),...e.invert&&{invert:u=>e.invert(u)}}}function uS(e,t){let{fx:n,fy:i}=kc(e,t),r=n?.scale.domain(),s=i?.scale.domain();return r&&s?h_(r,s).map(([o,a],c)=>({x:o,y:a,i:c})):r?r.map((o,a)=>({x:o,i:a})):s?s.map((o,a)=>({y:o,i:a})):void 0}function fS(e,{x:t,y:n}){return t&&(t=Wg(t)),n&&(n=Wg(n)),e.filter(t&&n?i=>t.has(i.x)&&n.has(i.y):t?i=>t.has(i.x):i=>n.has(i.y)).sort(t&&n?(i,r)=>t.get(i.x)-t.get(r.x)||n.get(i.y)-n.get(r.y):t?(i,r)=>t.get(i.x)-t.get(r.x):(i,r)=>n.get(i.y)-n.get(r.y))}function Gu(e,{fx:t,fy:n}){let i=fn(e),r=t?.value,s=n?.value;return t&&n?Ji(i,o=>(o.fx=r[o[0]],o.fy=s[o[0]],o),o=>r[o],o=>s[o]):t?Ji(i,o=>(o.fx=r[o[0]],o),o=>r[o]):Ji(i,o=>(o.fy=s[o[0]],o),o=>s[o])}function hS(e,t,{marginTop:n,marginLeft:i}){let r=e?({x:o})=>e(o)-i:()=>0,s=t?({y:o})=>t(o)-n:()=>0;return function(o){this.tagName==="svg"?(this.setAttribute("x",r(o)),this.setAttribute("y",s(o))):this.setAttribute("transform",`translate(${r(o)},${s(o)})`)}}function dS(e){let t=[],n=new Uint32Array(ri(e,i=>i.length));for(let i of e){let r=0;for(let s of e)i!==s&&(n.set(s,r),r+=s.length);t.push(n.slice(0,r))}return t}var IL=new Map([["top",zg],["right",Gg],["bottom",Vg],["left",Hg],["top-left",Hu(zg,Hg)],["top-right",Hu(zg,Gg)],["bottom-left",Hu(Vg,Hg)],["bottom-right",Hu(Vg,Gg)],["top-empty",LL],["right-empty",UL],["bottom-empty",NL],["left-empty",DL],["empty",FL]]);function pS(e){if(e==null)return null;let t=IL.get(`${e}`.toLowerCase());if(t)return t;throw new Error(`invalid facet anchor: ${e}`)}var lS=new WeakMap;function Wg(e){let t=lS.get(e);return t||lS.set(e,t=new On(ue(e,(n,i)=>[n,i]))),t}function Xr(e,t){return Wg(e).get(t)}function PL(e,t,n){return t=Jn(t),n=Jn(n),e.find(i=>Object.is(Jn(i.x),t)&&Object.is(Jn(i.y),n))}function Wu(e,t,n){return PL(e,t,n)?.empty}function zg(e,{y:t},{y:n}){return t?Xr(t,n)===0:!0}function Vg(e,{y:t},{y:n}){return t?Xr(t,n)===t.length-1:!0}function Hg(e,{x:t},{x:n}){return t?Xr(t,n)===0:!0}function Gg(e,{x:t},{x:n}){return t?Xr(t,n)===t.length-1:!0}function LL(e,{y:t},{x:n,y:i,empty:r}){if(r)return!1;if(!t)return;let s=Xr(t,i);if(s>0)return Wu(e,n,t[s-1])}function NL(e,{y:t},{x:n,y:i,empty:r}){if(r)return!1;if(!t)return;let s=Xr(t,i);if(s<t.length-1)return Wu(e,n,t[s+1])}function DL(e,{x:t},{x:n,y:i,empty:r}){if(r)return!1;if(!t)return;let s=Xr(t,n);if(s>0)return Wu(e,t[s-1],i)}function UL(e,{x:t},{x:n,y:i,empty:r}){if(r)return!1;if(!t)return;let s=Xr(t,n);if(s<t.length-1)return Wu(e,t[s+1],i)}function FL(e,t,{empty:n}){return n}function Hu(e,t){return function(){return e.apply(null,arguments)&&t.apply(null,arguments)}}function $u(e,{channels:{fx:t,fy:n},groups:i}){return t&&n?e.map(({x:r,y:s})=>i.get(r)?.get(s)??[]):t?e.map(({x:r})=>i.get(r)??[]):e.map(({y:r})=>i.get(r)??[])}var mS=Math.PI,hr=2*mS,$g=.618;function gS({projection:e,inset:t=0,insetTop:n=t,insetRight:i=t,insetBottom:r=t,insetLeft:s=t}={},o){if(e==null)return;if(typeof e.stream=="function")return e;let a,c,l="frame";if(ui(e)){let C;if({type:e,domain:c,inset:C,insetTop:n=C!==void 0?C:n,insetRight:i=C!==void 0?C:i,insetBottom:r=C!==void 0?C:r,insetLeft:s=C!==void 0?C:s,clip:l=l,...a}=e,e==null)return}typeof e!="function"&&({type:e}=Xg(e));let{width:u,height:h,marginLeft:f,marginRight:d,marginTop:m,marginBottom:y}=o,g=u-f-d-s-i,p=h-m-y-n-r;if(e=e?.({width:g,height:p,clip:l,...a}),e==null)return;l=OL(l,f,m,u-d,h-y);let _=f+s,b=m+n,x;if(c!=null){let[[C,w],[S,R]]=dc(e).bounds(c),M=Math.min(g/(S-C),p/(R-w));M>0?(_-=(M*(C+S)-g)/2,b-=(M*(w+R)-p)/2,x=pc({point(v,E){this.stream.point(v*M+_,E*M+b)}})):_n("Warning: the projection could not be fit to the specified domain; using the default scale.")}return x??(x=_===0&&b===0?yS():pc({point(C,w){this.stream.point(C+_,w+b)}})),{stream:C=>e.stream(x.stream(l(C)))}}function Xg(e){switch(`${e}`.toLowerCase()){case"albers-usa":return di(vb,.7463,.4673);case"albers":return Xu(qd,.7463,.4673);case"azimuthal-equal-area":return di(wb,4,4);case"azimuthal-equidistant":return di(Tb,hr,hr);case"conic-conformal":return Xu(Cb,hr,hr);case"conic-equal-area":return Xu(hc,6.1702,2.9781);case"conic-equidistant":return Xu(Ib,7.312,3.6282);case"equal-earth":return di(Lb,5.4133,2.6347);case"equirectangular":return di(Rb,hr,mS);case"gnomonic":return di(Db,3.4641,3.4641);case"identity":return{type:yS};case"reflect-y":return{type:BL};case"mercator":return di(Eb,hr,hr);case"orthographic":return di(Fb,2,2);case"stereographic":return di(Bb,2,2);case"transverse-mercator":return di(zb,hr,hr);default:throw new Error(`unknown projection type: ${e}`)}}function OL(e,t,n,i,r){if(e===!1||e==null||typeof e=="number")return s=>s;switch(e===!0&&(e="frame"),`${e}`.toLowerCase()){case"frame":return Wd(t,n,i,r);default:throw new Error(`unknown projection clip type: ${e}`)}}function di(e,t,n){return{type:({width:i,height:r,rotate:s,precision:o=.15,clip:a})=>{let c=e();return o!=null&&c.precision?.(o),s!=null&&c.rotate?.(s),typeof a=="number"&&c.clipAngle?.(a),i!=null&&(c.scale(Math.min(i/t,r/n)),c.translate([i/2,r/2])),c},aspectRatio:n/t}}function Xu(e,t,n){let{type:i,aspectRatio:r}=di(e,t,n);return{type:s=>{let{parallels:o,domain:a,width:c,height:l}=s,u=i(s);return o!=null&&(u.parallels(o),a===void 0&&c!=null&&u.fitSize([c,l],{type:"Sphere"})),u},aspectRatio:r}}var yS=An({stream:e=>e}),BL=An(pc({point(e,t){this.stream.point(e,-t)}}));function xS(e,t,n,i){let r=n[e],s=n[t],o=r.length,a=n[e]=new Float64Array(o).fill(NaN),c=n[t]=new Float64Array(o).fill(NaN),l,u=i.stream({point(h,f){a[l]=h,c[l]=f}});for(l=0;l<o;++l)u.point(r[l],s[l])}function _S({projection:e}={}){return e==null?!1:typeof e.stream=="function"?!0:(ui(e)&&(e=e.type),e!=null)}function vS(e){if(typeof e?.stream=="function")return $g;if(ui(e)){let t,n;if({domain:t,type:e,...n}=e,t!=null&&e!=null){let i=typeof e=="string"?Xg(e).type:e,[[r,s],[o,a]]=dc(i({...n,width:100,height:100})).bounds(t),c=(a-s)/(o-r);return c&&isFinite(c)?c<.2?.2:c>5?5:c:$g}}if(e!=null){if(typeof e!="function"){let{aspectRatio:t}=Xg(e);if(t)return t}return $g}}function bS(e){let t=[],n=[],i={scale:"x",value:t},r={scale:"y",value:n},s={point(o,a){t.push(o),n.push(a)},lineStart(){},lineEnd(){},polygonStart(){},polygonEnd(){},sphere(){}};for(let o of e.value)Ur(o,s);return[i,r]}function MS({x:e,y:t}){if(e||t)return e??(e=n=>n),t??(t=n=>n),pc({point(n,i){this.stream.point(e(n),t(i))}})}function ia(e={}){let{document:t=typeof window<"u"?window.document:void 0,clip:n}=e;return{document:t,clip:Fu(n)}}function te(e,{document:t}){return si(wo(e).call(t.documentElement))}var Yu=Symbol("unset");function qu(e){return(e.length===1?kL:zL)(e)}function kL(e){let t,n=Yu;return i=>(Object.is(n,i)||(n=i,t=e(i)),t)}function zL(e){let t,n;return(...i)=>((n?.length!==i.length||n.some((r,s)=>!Object.is(r,i[s])))&&(n=i,t=e(...i)),t)}var VL=qu(e=>new Intl.NumberFormat(e)),g7=qu((e,t)=>new Intl.DateTimeFormat(e,{timeZone:"UTC",...t&&{month:t}})),y7=qu((e,t)=>new Intl.DateTimeFormat(e,{timeZone:"UTC",...t&&{weekday:t}}));function HL(e="en-US"){let t=VL(e);return n=>n!=null&&!isNaN(n)?t.format(n):void 0}function GL(e){return Au(e,"Invalid Date")}function WL(e="en-US"){let t=HL(e);return n=>(n instanceof Date?GL:typeof n=="number"?t:Ie)(n)}var Vi=WL();var Ke=(typeof window<"u"?window.devicePixelRatio>1:typeof it>"u")?0:.5,$L=0;function SS(){return`plot-clip-${++$L}`}function TS(e,{title:t,href:n,ariaLabel:i,ariaDescription:r,ariaHidden:s,target:o,fill:a,fillOpacity:c,stroke:l,strokeWidth:u,strokeOpacity:h,strokeLinejoin:f,strokeLinecap:d,strokeMiterlimit:m,strokeDasharray:y,strokeDashoffset:g,opacity:p,mixBlendMode:_,imageFilter:b,paintOrder:x,pointerEvents:C,shapeRendering:w,channels:S},{ariaLabel:R,fill:M="currentColor",fillOpacity:v,stroke:E="none",strokeOpacity:N,strokeWidth:U,strokeLinecap:F,strokeLinejoin:P,strokeMiterlimit:O,paintOrder:H}){M===null&&(a=null,c=null),E===null&&(l=null,h=null),Xe(M)?!Xe(E)&&(!Xe(a)||S?.fill)&&(E="none"):Xe(E)&&(!Xe(l)||S?.stroke)&&(M="none");let[z,G]=ln(a,M),[j,nt]=Ae(c,v),[ct,ft]=ln(l,E),[$,tt]=Ae(h,N),[lt,K]=Ae(p);ks(ft)||(u===void 0&&(u=U),d===void 0&&(d=F),f===void 0&&(f=P),m===void 0&&!KM(f)&&(m=O),!ks(G)&&x===void 0&&(x=H));let[ut,q]=Ae(u);return M!==null&&(e.fill=Ce(G,"currentColor"),e.fillOpacity=zc(nt,1)),E!==null&&(e.stroke=Ce(ft,"none"),e.strokeWidth=zc(q,1),e.strokeOpacity=zc(tt,1),e.strokeLinejoin=Ce(f,"miter"),e.strokeLinecap=Ce(d,"butt"),e.strokeMiterlimit=zc(m,4),e.strokeDasharray=Ce(y,"none"),e.strokeDashoffset=Ce(g,"0")),e.target=Ie(o),e.ariaLabel=Ie(R),e.ariaDescription=Ie(r),e.ariaHidden=Ie(s),e.opacity=zc(K,1),e.mixBlendMode=Ce(_,"normal"),e.imageFilter=Ce(b,"none"),e.paintOrder=Ce(x,"normal"),e.pointerEvents=Ce(C,"auto"),e.shapeRendering=Ce(w,"auto"),{title:{value:t,optional:!0,filter:null},href:{value:n,optional:!0,filter:null},ariaLabel:{value:i,optional:!0,filter:null},fill:{value:z,scale:"auto",optional:!0},fillOpacity:{value:j,scale:"auto",optional:!0},stroke:{value:ct,scale:"auto",optional:!0},strokeOpacity:{value:$,scale:"auto",optional:!0},strokeWidth:{value:ut,optional:!0},opacity:{value:lt,scale:"auto",optional:!0}}}function XL(e,t){t&&e.filter(n=>Ac(t[n])).append("title").call(qL,t)}function YL(e,t){t&&e.filter(([n])=>Ac(t[n])).append("title").call(ZL,t)}function qL(e,t){t&&e.text(n=>Vi(t[n]))}function ZL(e,t){t&&e.text(([n])=>Vi(t[n]))}function je(e,{target:t,tip:n},{ariaLabel:i,title:r,fill:s,fillOpacity:o,stroke:a,strokeOpacity:c,strokeWidth:l,opacity:u,href:h}){i&&Ft(e,"aria-label",f=>i[f]),s&&Ft(e,"fill",f=>s[f]),o&&Ft(e,"fill-opacity",f=>o[f]),a&&Ft(e,"stroke",f=>a[f]),c&&Ft(e,"stroke-opacity",f=>c[f]),l&&Ft(e,"stroke-width",f=>l[f]),u&&Ft(e,"opacity",f=>u[f]),h&&ES(e,f=>h[f],t),n||XL(e,r)}function Zu(e,{target:t,tip:n},{ariaLabel:i,title:r,fill:s,fillOpacity:o,stroke:a,strokeOpacity:c,strokeWidth:l,opacity:u,href:h}){i&&Ft(e,"aria-label",([f])=>i[f]),s&&Ft(e,"fill",([f])=>s[f]),o&&Ft(e,"fill-opacity",([f])=>o[f]),a&&Ft(e,"stroke",([f])=>a[f]),c&&Ft(e,"stroke-opacity",([f])=>c[f]),l&&Ft(e,"stroke-width",([f])=>l[f]),u&&Ft(e,"opacity",([f])=>u[f]),h&&ES(e,([f])=>h[f],t),n||YL(e,r)}function JL({ariaLabel:e,title:t,fill:n,fillOpacity:i,stroke:r,strokeOpacity:s,strokeWidth:o,opacity:a,href:c},{tip:l}){return[e,l?void 0:t,n,i,r,s,o,a,c].filter(u=>u!==void 0)}function KL(e,t,n){let i=ms(e,r=>t[r]);return n===void 0&&i.size>1+e.length>>1&&_n("Warning: the implicit z channel has high cardinality. This may occur when the fill or stroke channel is associated with quantitative data rather than ordinal or categorical data. You can suppress this warning by setting the z option explicitly; if this data represents a single series, set z to null."),i.values()}function*Ju(e,t,n,i){let{z:r}=n,{z:s}=i,o=JL(i,n),a=[...t,...o];for(let c of s?KL(e,s,r):[e]){let l,u;t:for(let h of c){for(let f of a)if(!qn(f[h])){u&&u.push(-1);continue t}if(l===void 0){u&&(yield u),l=o.map(f=>Jn(f[h])),u=[h];continue}u.push(h);for(let f=0;f<o.length;++f)if(Jn(o[f][h])!==l[f]){yield u,l=o.map(m=>Jn(m[h])),u=[h];continue t}}u&&(yield u)}}function jL(e,t,n,i){let r,{clip:s=i.clip}=t;s==="frame"?(e=te("svg:g",i).each(function(){this.appendChild(e.node()),e.node=()=>this}),r=tN(i,n)):s&&(r=nN(s,i)),Ft(e,"aria-label",t.ariaLabel),Ft(e,"aria-description",t.ariaDescription),Ft(e,"aria-hidden",t.ariaHidden),Ft(e,"clip-path",r)}function QL(e){let t=new WeakMap;return(n,i)=>{let r=t.get(n);if(!r){let s=SS();si(n.ownerSVGElement).append("clipPath").attr("id",s).call(e,n,i),t.set(n,r=`url(#${s})`)}return r}}var tN=QL((e,t,n)=>{let{width:i,height:r,marginLeft:s,marginRight:o,marginTop:a,marginBottom:c}=n;e.append("rect").attr("x",s).attr("y",a).attr("width",i-o-s).attr("height",r-a-c)}),wS=new WeakMap,eN={type:"Sphere"};function nN(e,t){let n,i;if((n=wS.get(t))||wS.set(t,n=new WeakMap),e.type==="Sphere"&&(e=eN),!(i=n.get(e))){let r=SS();si(t.ownerSVGElement).append("clipPath").attr("id",r).append("path").attr("d",t.path()(e)),n.set(e,i=`url(#${r})`)}return i}function Le(e,t,n,i){jL(e,t,n,i),Ft(e,"class",t.className),Ft(e,"fill",t.fill),Ft(e,"fill-opacity",t.fillOpacity),Ft(e,"stroke",t.stroke),Ft(e,"stroke-width",t.strokeWidth),Ft(e,"stroke-opacity",t.strokeOpacity),Ft(e,"stroke-linejoin",t.strokeLinejoin),Ft(e,"stroke-linecap",t.strokeLinecap),Ft(e,"stroke-miterlimit",t.strokeMiterlimit),Ft(e,"stroke-dasharray",t.strokeDasharray),Ft(e,"stroke-dashoffset",t.strokeDashoffset),Ft(e,"shape-rendering",t.shapeRendering),Ft(e,"filter",t.imageFilter),Ft(e,"paint-order",t.paintOrder);let{pointerEvents:r=i.pointerSticky===!1?"none":void 0}=t;Ft(e,"pointer-events",r)}function Me(e,t){iN(e,"mix-blend-mode",t.mixBlendMode),Ft(e,"opacity",t.opacity)}function ES(e,t,n){e.each(function(i){let r=t(i);if(r!=null){let s=this.ownerDocument.createElementNS(Lr.svg,"a");s.setAttribute("fill","inherit"),s.setAttributeNS(Lr.xlink,"href",r),n!=null&&s.setAttribute("target",n),this.parentNode.insertBefore(s,this).appendChild(this)}})}function Ft(e,t,n){n!=null&&e.attr(t,n)}function iN(e,t,n){n!=null&&e.style(t,n)}function we(e,t,{x:n,y:i},r=Ke,s=Ke){r+=t.dx,s+=t.dy,n?.bandwidth&&(r+=n.bandwidth()/2),i?.bandwidth&&(s+=i.bandwidth()/2),(r||s)&&e.attr("transform",`translate(${r},${s})`)}function Ce(e,t){if((e=Ie(e))!==t)return e}function zc(e,t){if((e=Pe(e))!==t)return e}var rN=/^-?([_a-z]|[\240-\377]|\\[0-9a-f]{1,6}(\r\n|[ \t\r\n\f])?|\\[^\r\n\f0-9a-f])([_a-z0-9-]|[\240-\377]|\\[0-9a-f]{1,6}(\r\n|[ \t\r\n\f])?|\\[^\r\n\f0-9a-f])*$/i;function ra(e){if(e===void 0)return"plot-d6a7b5";if(e=`${e}`,!rN.test(e))throw new Error(`invalid class name: ${e}`);return e}function sa(e,t){if(typeof t=="string")e.property("style",t);else if(t!=null)for(let n of e)Object.assign(n.style,t)}function Hi({frameAnchor:e},{width:t,height:n,marginTop:i,marginRight:r,marginBottom:s,marginLeft:o}){return[/left$/.test(e)?o:/right$/.test(e)?t-r:(o+t-r)/2,/^top/.test(e)?i:/^bottom/.test(e)?n-s:(i+n-s)/2]}var de=class{constructor(t,n={},i={},r){let{facet:s="auto",facetAnchor:o,fx:a,fy:c,sort:l,dx:u=0,dy:h=0,margin:f=0,marginTop:d=f,marginRight:m=f,marginBottom:y=f,marginLeft:g=f,className:p,clip:_=r?.clip,channels:b,tip:x,render:C}=i;if(this.data=t,this.sort=Hr(l)?l:null,this.initializer=cr(i).initializer,this.transform=this.initializer?i.transform:Gs(i).transform,s===null||s===!1?this.facet=null:(this.facet=un(s===!0?"include":s,"facet",["auto","include","exclude","super"]),this.fx=t===Go&&typeof a=="string"?[a]:a,this.fy=t===Go&&typeof c=="string"?[c]:c),this.facetAnchor=pS(o),n=mg(n),b!==void 0&&(n={...sN(b),...n}),r!==void 0&&(n={...TS(this,i,r),...n}),this.channels=Object.fromEntries(Object.entries(n).map(([w,S])=>{if($o(S.value)){let{value:R,label:M=S.label,scale:v=S.scale}=S.value;S={...S,label:M,scale:v,value:R}}if(t===Go&&typeof S.value=="string"){let{value:R}=S;S={...S,value:[R]}}return[w,S]}).filter(([w,{value:S,optional:R}])=>{if(S!=null)return!0;if(R)return!1;throw new Error(`missing channel value: ${w}`)})),this.dx=+u,this.dy=+h,this.marginTop=+d,this.marginRight=+m,this.marginBottom=+y,this.marginLeft=+g,this.clip=Fu(_),this.tip=oN(x),this.className=Ie(p),this.facet==="super"){if(a||c)throw new Error("super-faceting cannot use fx or fy");for(let w in this.channels){let{scale:S}=n[w];if(!(S!=="x"&&S!=="y"))throw new Error("super-faceting cannot use x or y")}}C!=null&&(this.render=qg(C,this.render))}initialize(t,n,i){let r=ar(this.data);t===void 0&&r!=null&&(t=[fn(r)]);let s=t;this.transform!=null&&({facets:t,data:r}=this.transform(r,t,i),r=ar(r)),t!==void 0&&(t.original=s);let o=gw(this.channels,r);return this.sort!=null&&xw(r,t,o,n,this.sort),{data:r,facets:t,channels:o}}filter(t,n,i){for(let r in n){let{filter:s=qn}=n[r];if(s!==null){let o=i[r];t=t.filter(a=>s(o[a]))}}return t}project(t,n,i){for(let r in t)if(t[r].scale==="x"&&/^x|x$/.test(r)){let s=r.replace(/^x|x$/,"y");s in t&&t[s].scale==="y"&&xS(r,s,n,i.projection)}}scale(t,n,i){let r=yw(t,n);return i.projection&&this.project(t,r,i),r}};function Yg(...e){return e.plot=de.prototype.plot,e}function qg(e,t){if(e==null)return t===null?void 0:t;if(t==null)return e===null?void 0:e;if(typeof e!="function")throw new TypeError(`invalid render transform: ${e}`);if(typeof t!="function")throw new TypeError(`invalid render transform: ${t}`);return function(n,i,r,s,o,a){return e.call(this,n,i,r,s,o,(c,l,u,h,f)=>t.call(this,c,l,u,h,f,a))}}function sN(e){return Object.fromEntries(Object.entries(mg(e)).map(([t,n])=>(n=typeof n=="string"?{value:n,label:t}:ki(n),n.filter===void 0&&n.scale==null&&(n={...n,filter:null}),[t,n])))}function oN(e){return e===!0?"xy":e===!1||e==null?null:typeof e=="string"?un(e,"tip",["x","y","xy"]):e}function Ws(e,t){return e?.tip===!0?{...e,tip:t}:ui(e?.tip)&&e.tip.pointer===void 0?{...e,tip:{...e.tip,pointer:t}}:e}function CS(e,t,n={}){let i=.5-Ke,r=.5+Ke,s=.5+Ke,o=.5-Ke;for(let{marginTop:y,marginRight:g,marginBottom:p,marginLeft:_}of t)y>i&&(i=y),g>r&&(r=g),p>s&&(s=p),_>o&&(o=_);let{margin:a,marginTop:c=a!==void 0?a:i,marginRight:l=a!==void 0?a:r,marginBottom:u=a!==void 0?a:s,marginLeft:h=a!==void 0?a:o}=n;c=+c,l=+l,u=+u,h=+h;let{width:f=640,height:d=aN(e,n,{width:f,marginTopDefault:i,marginRightDefault:r,marginBottomDefault:s,marginLeftDefault:o})+Math.max(0,c-i+u-s)}=n;f=+f,d=+d;let m={width:f,height:d,marginTop:c,marginRight:l,marginBottom:u,marginLeft:h};if(e.fx||e.fy){let{margin:y,marginTop:g=y!==void 0?y:c,marginRight:p=y!==void 0?y:l,marginBottom:_=y!==void 0?y:u,marginLeft:b=y!==void 0?y:h}=n.facet??{};g=+g,p=+p,_=+_,b=+b,m.facet={marginTop:g,marginRight:p,marginBottom:_,marginLeft:b}}return m}function aN({x:e,y:t,fy:n,fx:i},{projection:r,aspectRatio:s},{width:o,marginTopDefault:a,marginRightDefault:c,marginBottomDefault:l,marginLeftDefault:u}){let h=n&&n.scale.domain().length||1,f=vS(r);if(f){let m=i?i.scale.domain().length:1,y=(1.1*h-.1)/(1.1*m-.1)*f,g=Math.max(.1,Math.min(10,y));return Math.round((o-u-c)*g+a+l)}let d=t?zi(t)?t.scale.domain().length||1:Math.max(7,17/h):1;if(s!=null){if(s=+s,!(isFinite(s)&&s>0))throw new Error(`invalid aspectRatio: ${s}`);let m=AS("y",t)/(AS("x",e)*s),y=i?i.scale.bandwidth():1,g=n?n.scale.bandwidth():1,p=y*(o-u-c)-e.insetLeft-e.insetRight;return(m*p+t.insetTop+t.insetBottom)/g+a+l}return!!(t||n)*Math.max(1,Math.min(60,d*h))*20+!!i*30+60}function AS(e,t){if(!t)throw new Error(`aspectRatio requires ${e} scale`);let{type:n,domain:i}=t,r;switch(n){case"linear":case"utc":case"time":r=Number;break;case"pow":{let a=t.scale.exponent();r=c=>Math.pow(c,a);break}case"log":r=Math.log;break;case"point":case"band":return i.length;default:throw new Error(`unsupported ${e} scale for aspectRatio: ${n}`)}let[s,o]=Je(i);return Math.abs(r(o)-r(s))}var RS=new WeakMap;function Zg(e,t,{x:n,y:i,px:r,py:s,maxRadius:o=40,channels:a,render:c,...l}={}){return o=+o,r!=null&&(n??(n=null),a={...a,px:{value:r,scale:"x"}}),s!=null&&(i??(i=null),a={...a,py:{value:s,scale:"y"}}),{x:n,y:i,channels:a,...l,render:qg(function(u,h,f,d,m,y){m={...m,pointerSticky:!1};let g=m.ownerSVGElement,{data:p}=m.getMarkState(this),_=RS.get(g);_||RS.set(g,_={sticky:!1,roots:[],renders:[]});let b=_.renders.push(ft)-1,{x,y:C,fx:w,fy:S}=h,R=w?w(u.fx)-d.marginLeft:0,M=S?S(u.fy)-d.marginTop:0;x?.bandwidth&&(R+=x.bandwidth()/2),C?.bandwidth&&(M+=C.bandwidth()/2);let v=u.fi!=null,E;if(v){let K=_.facetStates;K||(_.facetStates=K=new Map),E=K.get(this),E||K.set(this,E=new Map)}let[N,U]=Hi(this,d),{px:F,py:P}=f,O=F?K=>F[K]:Jg(f,N),H=P?K=>P[K]:Kg(f,U),z,G,j,nt;function ct(K,ut){if(v)if(nt&&(nt=cancelAnimationFrame(nt)),K==null)E.delete(u.fi);else{E.set(u.fi,ut),nt=requestAnimationFrame(()=>{nt=null;for(let[q,ot]of E)if(ot<ut||ot===ut&&q<u.fi){K=null;break}ft(K)});return}ft(K)}function ft(K){if(z===K&&j===_.sticky)return;z=K,j=m.pointerSticky=_.sticky;let ut=z==null?[]:[z];v&&(ut.fx=u.fx,ut.fy=u.fy,ut.fi=u.fi);let q=y(ut,h,f,d,m);if(G){if(v){let ot=G.parentNode,pt=G.getAttribute("transform"),X=q.getAttribute("transform");pt?q.setAttribute("transform",pt):q.removeAttribute("transform"),X?ot.setAttribute("transform",X):ot.removeAttribute("transform"),q.removeAttribute("aria-label"),q.removeAttribute("aria-description"),q.removeAttribute("aria-hidden")}G.replaceWith(q)}if(_.roots[b]=G=q,!(z==null&&E?.size>1)){let ot=z==null?null:ci(p)?p[z]:p.get(z);m.dispatchValue(ot)}return q}function $(K){if(_.sticky||K.pointerType==="mouse"&&K.buttons===1)return;let[ut,q]=V_(K);ut-=R,q-=M;let ot=ut<d.marginLeft||ut>d.width-d.marginRight?1:e,pt=q<d.marginTop||q>d.height-d.marginBottom?1:t,X=null,Lt=o*o;for(let L of u){let Ot=ot*(O(L)-ut),St=pt*(H(L)-q),Ut=Ot*Ot+St*St;Ut<=Lt&&(X=L,Lt=Ut)}if(X!=null&&(e!==1||t!==1)){let L=O(X)-ut,Ot=H(X)-q;Lt=L*L+Ot*Ot}ct(X,Lt)}function tt(K){K.pointerType==="mouse"&&z!=null&&(_.sticky&&_.roots.some(ut=>ut?.contains(K.target))||(_.sticky?(_.sticky=!1,_.renders.forEach(ut=>ut(null))):(_.sticky=!0,ft(z)),K.stopImmediatePropagation()))}function lt(K){K.pointerType==="mouse"&&(_.sticky||ct(null))}return g.addEventListener("pointerenter",$),g.addEventListener("pointermove",$),g.addEventListener("pointerdown",tt),g.addEventListener("pointerleave",lt),ft(null)},c)}}function Vc(e){return Zg(1,1,e)}function Hc(e){return Zg(1,.01,e)}function Ku(e){return Zg(.01,1,e)}function Jg({x1:e,x2:t,x:n=e},i){return e&&t?r=>(e[r]+t[r])/2:n?r=>n[r]:()=>i}function Kg({y1:e,y2:t,y:n=e},i){return e&&t?r=>(e[r]+t[r])/2:n?r=>n[r]:()=>i}function ju(e){return zi(e)&&e.interval===void 0?void 0:"tabular-nums"}function IS(e,t){let{label:n=e.label,tickSize:i=6,width:r=240,height:s=44+i,marginTop:o=18,marginRight:a=0,marginBottom:c=16+i,marginLeft:l=0,style:u,ticks:h=(r-l-a)/64,tickFormat:f,fontVariant:d=ju(e),round:m=!0,opacity:y,className:g}=t,p=ia(t);g=ra(g),y=Ae(y)[1],f===null&&(f=()=>null);let _=te("svg",p).attr("class",`${g}-ramp`).attr("font-family","system-ui, sans-serif").attr("font-size",10).attr("width",r).attr("height",s).attr("viewBox",`0 0 ${r} ${s}`).call(N=>N.append("style").text(`:where(.${g}-ramp) {
  display: block;
  height: auto;
  height: intrinsic;
  max-width: 100%;
  overflow: visible;
}
:where(.${g}-ramp text) {
  white-space: pre;
}`)).call(sa,u),b=N=>N.selectAll(".tick line").attr("y1",o+c-s),x,C=m?(N,U)=>N.rangeRound(U):(N,U)=>N.range(U),{type:w,domain:S,range:R,interpolate:M,scale:v,pivot:E}=e;if(M){let N=R===void 0?M:Dr(M.length===1?Bc(M):M,R);x=C(v.copy(),on(Oe(l,r-a),Math.min(S.length+(E!==void 0),R===void 0?1/0:R.length)));let U=256,F=p.document.createElement("canvas");F.width=U,F.height=1;let P=F.getContext("2d");for(let O=0,H=U-1;O<U;++O)P.fillStyle=N(O/H),P.fillRect(O,0,1,1);_.append("image").attr("opacity",y).attr("x",l).attr("y",o).attr("width",r-l-a).attr("height",s-o-c).attr("preserveAspectRatio","none").attr("xlink:href",F.toDataURL())}else if(w==="threshold"){let N=S,U=f===void 0?F=>F:typeof f=="string"?Ei(f):f;x=C(wc().domain([-1,R.length-1]),[l,r-a]),_.append("g").attr("fill-opacity",y).selectAll().data(R).enter().append("rect").attr("x",(F,P)=>x(P-1)).attr("y",o).attr("width",(F,P)=>x(P)-x(P-1)).attr("height",s-o-c).attr("fill",F=>F),h=ue(N,(F,P)=>P),f=F=>U(N[F],F)}else x=C(Bo().domain(S),[l,r-a]),_.append("g").attr("fill-opacity",y).selectAll().data(S).enter().append("rect").attr("x",x).attr("y",o).attr("width",Math.max(0,x.bandwidth()-1)).attr("height",s-o-c).attr("fill",v),b=()=>{};return _.append("g").attr("transform",`translate(0,${s-c})`).call(R_(x).ticks(Array.isArray(h)?null:h,typeof f=="string"?f:void 0).tickFormat(typeof f=="function"?f:void 0).tickSize(i).tickValues(Array.isArray(h)?h:null)).attr("font-size",null).attr("font-family",null).attr("font-variant",Ce(d,"normal")).call(b).call(N=>N.select(".domain").remove()),n!==void 0&&_.append("text").attr("x",l).attr("y",o-6).attr("fill","currentColor").attr("font-weight","bold").text(n),_.node()}var jg=Math.PI/180;function Gc(e,{marker:t,markerStart:n=t,markerMid:i=t,markerEnd:r=t}={}){e.markerStart=Qg(n),e.markerMid=Qg(i),e.markerEnd=Qg(r)}function Qg(e){if(e==null||e===!1)return null;if(e===!0)return LS;if(typeof e=="function")return e;switch(`${e}`.toLowerCase()){case"none":return null;case"arrow":return PS("auto");case"arrow-reverse":return PS("auto-start-reverse");case"dot":return cN;case"circle":case"circle-fill":return LS;case"circle-stroke":return lN;case"tick":return t0("auto");case"tick-x":return t0(90);case"tick-y":return t0(0)}throw new Error(`invalid marker: ${e}`)}function PS(e){return(t,n)=>te("svg:marker",n).attr("viewBox","-5 -5 10 10").attr("markerWidth",6.67).attr("markerHeight",6.67).attr("orient",e).attr("fill","none").attr("stroke",t).attr("stroke-width",1.5).attr("stroke-linecap","round").attr("stroke-linejoin","round").call(i=>i.append("path").attr("d","M-1.5,-3l3,3l-3,3")).node()}function cN(e,t){return te("svg:marker",t).attr("viewBox","-5 -5 10 10").attr("markerWidth",6.67).attr("markerHeight",6.67).attr("fill",e).attr("stroke","none").call(n=>n.append("circle").attr("r",2.5)).node()}function LS(e,t){return te("svg:marker",t).attr("viewBox","-5 -5 10 10").attr("markerWidth",6.67).attr("markerHeight",6.67).attr("fill",e).attr("stroke","var(--plot-background)").attr("stroke-width",1.5).call(n=>n.append("circle").attr("r",3)).node()}function lN(e,t){return te("svg:marker",t).attr("viewBox","-5 -5 10 10").attr("markerWidth",6.67).attr("markerHeight",6.67).attr("fill","var(--plot-background)").attr("stroke",e).attr("stroke-width",1.5).call(n=>n.append("circle").attr("r",3)).node()}function t0(e){return(t,n)=>te("svg:marker",n).attr("viewBox","-3 -3 6 6").attr("markerWidth",6).attr("markerHeight",6).attr("orient",e).attr("stroke",t).call(i=>i.append("path").attr("d","M0,-3v6")).node()}var uN=0;function n0(e,t,{stroke:n},i){return US(e,t,n&&(r=>n[r]),null,i)}function NS(e,t,{stroke:n,z:i},r){return US(e,t,n&&(([s])=>n[s]),i,r)}var e0=1,DS=2;function fN(e,t){let n=new Uint8Array(t.length),i=e.data().filter(s=>s.length>1),r=i.length;for(let s=0,o=Yu;s<r;++s){let a=i[s];if(a.length>1){let c=a[0];o!==(o=Jn(t[c]))&&(n[c]|=e0)}}for(let s=r-1,o=Yu;s>=0;--s){let a=i[s];if(a.length>1){let c=a[0];o!==(o=Jn(t[c]))&&(n[c]|=DS)}}return([s])=>n[s]}function US(e,{markerStart:t,markerMid:n,markerEnd:i,stroke:r},s=()=>r,o,a){if(!t&&!n&&!i)return;let c=new Map,l=o&&fN(e,o);function u(h,f,d){return function(m){if(d&&!d(m))return;let y=s(m),g=c.get(f);g||c.set(f,g=new Map);let p=g.get(y);if(!p){let _=this.parentNode.insertBefore(f(y,a),this),b=`plot-marker-${++uN}`;_.setAttribute("id",b),g.set(y,p=`url(#${b})`)}this.setAttribute(h,p)}}t&&e.each(u("marker-start",t,l&&(h=>l(h)&e0))),n&&l&&e.each(u("marker-start",n,h=>!(l(h)&e0))),n&&e.each(u("marker-mid",n)),i&&e.each(u("marker-end",i,l&&(h=>l(h)&DS)))}function oa({inset:e,insetLeft:t,insetRight:n,...i}={}){return[t,n]=FS(e,t,n),{inset:e,insetLeft:t,insetRight:n,...i}}function Wc({inset:e,insetTop:t,insetBottom:n,...i}={}){return[t,n]=FS(e,t,n),{inset:e,insetTop:t,insetBottom:n,...i}}function FS(e,t,n){return e===void 0&&t===void 0&&n===void 0?Ke?[1,0]:[.5,.5]:[t,n]}function OS(e,{interval:t}){return e={...ki(e)},e.interval=Lu(e.interval===void 0?t:e.interval),e}function Qu(e,t,n,i){let{[e]:r,[`${e}1`]:s,[`${e}2`]:o}=n,{value:a,interval:c}=OS(r,n);if(a==null||c==null&&!i)return n;let l=fi(r);if(c==null){let d,m={transform:y=>d||(d=ve(y,a)),label:l};return{...n,[e]:void 0,[`${e}1`]:s===void 0?m:s,[`${e}2`]:o===void 0&&!(s===o&&i)?m:o}}let u,h;function f(d){return h!==void 0&&d===u?h:h=ue(ve(u=d,a),m=>c.floor(m))}return t({...n,[e]:void 0,[`${e}1`]:s===void 0?{transform:f,label:l}:s,[`${e}2`]:o===void 0?{transform:d=>f(d).map(m=>c.offset(m)),label:l}:o})}function BS(e,t,n){let{[e]:i}=n,{value:r,interval:s}=OS(i,n);return r==null||s==null?n:t({...n,[e]:{label:fi(i),transform:o=>{let a=ue(ve(o,r),l=>s.floor(l)),c=a.map(l=>s.offset(l));return a.map(Re(a)?(l,u)=>l==null||isNaN(l=+l)||(u=c[u],u==null)||isNaN(u=+u)?void 0:new Date((l+u)/2):(l,u)=>l==null||(u=c[u],u==null)?NaN:(+l+ +u)/2)}}})}function kS(e={}){return Qu("x",oa,e,!0)}function zS(e={}){return Qu("y",Wc,e,!0)}function i0(e={}){return Qu("x",oa,e)}function tf(e={}){return Qu("y",Wc,e)}function VS(e={}){return BS("x",oa,e)}function HS(e={}){return BS("y",Wc,e)}var GS={ariaLabel:"rule",fill:null,stroke:"currentColor"},ef=class extends de{constructor(t,n={}){let{x:i,y1:r,y2:s,inset:o=0,insetTop:a=o,insetBottom:c=o}=n;super(t,{x:{value:i,scale:"x",optional:!0},y1:{value:r,scale:"y",optional:!0},y2:{value:s,scale:"y",optional:!0}},Ws(n,"x"),GS),this.insetTop=Pe(a),this.insetBottom=Pe(c),Gc(this,n)}render(t,n,i,r,s){let{x:o,y:a}=n,{x:c,y1:l,y2:u}=i,{width:h,height:f,marginTop:d,marginRight:m,marginLeft:y,marginBottom:g}=r,{insetTop:p,insetBottom:_}=this;return te("svg:g",s).call(Le,this,r,s).call(we,this,{x:c&&o},Ke,0).call(b=>b.selectAll().data(t).enter().append("line").call(Me,this).attr("x1",c?x=>c[x]:(y+h-m)/2).attr("x2",c?x=>c[x]:(y+h-m)/2).attr("y1",l&&!hi(a)?x=>l[x]+p:d+p).attr("y2",u&&!hi(a)?a.bandwidth?x=>u[x]+a.bandwidth()-_:x=>u[x]-_:f-g-_).call(je,this,i).call(n0,this,i,s)).node()}},nf=class extends de{constructor(t,n={}){let{x1:i,x2:r,y:s,inset:o=0,insetRight:a=o,insetLeft:c=o}=n;super(t,{y:{value:s,scale:"y",optional:!0},x1:{value:i,scale:"x",optional:!0},x2:{value:r,scale:"x",optional:!0}},Ws(n,"y"),GS),this.insetRight=Pe(a),this.insetLeft=Pe(c),Gc(this,n)}render(t,n,i,r,s){let{x:o,y:a}=n,{y:c,x1:l,x2:u}=i,{width:h,height:f,marginTop:d,marginRight:m,marginLeft:y,marginBottom:g}=r,{insetLeft:p,insetRight:_}=this;return te("svg:g",s).call(Le,this,r,s).call(we,this,{y:c&&a},0,Ke).call(b=>b.selectAll().data(t).enter().append("line").call(Me,this).attr("x1",l&&!hi(o)?x=>l[x]+p:y+p).attr("x2",u&&!hi(o)?o.bandwidth?x=>u[x]+o.bandwidth()-_:x=>u[x]-_:h-m-_).attr("y1",c?x=>c[x]:(d+f-g)/2).attr("y2",c?x=>c[x]:(d+f-g)/2).call(je,this,i).call(n0,this,i,s)).node()}};function Yr(e,t){let{x:n=fe,y:i,y1:r,y2:s,...o}=tf(t);return[r,s]=WS(i,r,s),new ef(e,{...o,x:n,y1:r,y2:s})}function $s(e,t){let{y:n=fe,x:i,x1:r,x2:s,...o}=i0(t);return[r,s]=WS(i,r,s),new nf(e,{...o,y:n,x1:r,x2:s})}function WS(e,t,n){if(e==null){if(t===void 0){if(n!==void 0)return[0,n]}else if(n===void 0)return[0,t]}else{if(t===void 0)return n===void 0?[0,e]:[e,n];if(n===void 0)return[e,t]}return[t,n]}function aa(e,...t){let n=t.length;for(let i=0,r=!0;i<n;++i)typeof t[i]!="function"&&(r&&(e=e.slice(),r=!1),e.splice(i,2,e[i]+t[i]+e[i+1]),t.splice(i,1),--i,--n);return i=>{let r=e[0];for(let s=0;s<n;++s)r+=t[s](i)+e[s+1];return r}}var hN={ariaLabel:"text",strokeLinejoin:"round",strokeWidth:3,paintOrder:"stroke"},ZS="­",ca=class extends de{constructor(t,n={}){let{x:i,y:r,text:s=xn(t)&&Nu(t)?fe:li,frameAnchor:o,textAnchor:a=/right$/i.test(o)?"end":/left$/i.test(o)?"start":"middle",lineAnchor:c=/^top/i.test(o)?"top":/^bottom/i.test(o)?"bottom":"middle",lineHeight:l=1,lineWidth:u=1/0,textOverflow:h,monospace:f,fontFamily:d=f?"ui-monospace, monospace":void 0,fontSize:m,fontStyle:y,fontVariant:g,fontWeight:p,rotate:_}=n,[b,x]=Ae(_,0),[C,w]=gN(m);if(super(t,{x:{value:i,scale:"x",optional:!0},y:{value:r,scale:"y",optional:!0},fontSize:{value:C,optional:!0},rotate:{value:XM(b),optional:!0},text:{value:s,filter:Ac,optional:!0}},n,hN),this.rotate=x,this.textAnchor=Ce(a,"middle"),this.lineAnchor=un(c,"lineAnchor",["top","middle","bottom"]),this.lineHeight=+l,this.lineWidth=+u,this.textOverflow=s0(h),this.monospace=!!f,this.fontFamily=Ie(d),this.fontSize=w,this.fontStyle=Ie(y),this.fontVariant=Ie(g),this.fontWeight=Ie(p),this.frameAnchor=$r(o),!(this.lineWidth>=0))throw new Error(`invalid lineWidth: ${u}`);this.splitLines=l0(this),this.clipLine=u0(this)}render(t,n,i,r,s){let{x:o,y:a}=n,{x:c,y:l,rotate:u,text:h,title:f,fontSize:d}=i,{rotate:m}=this,[y,g]=Hi(this,r);return te("svg:g",s).call(Le,this,r,s).call(c0,this,h,r).call(we,this,{x:c&&o,y:l&&a}).call(p=>p.selectAll().data(t).enter().append("text").call(Me,this).call(dN,this,h,f).attr("transform",aa`translate(${c?_=>c[_]:y},${l?_=>l[_]:g})${u?_=>` rotate(${u[_]})`:m?` rotate(${m})`:""}`).call(Ft,"font-size",d&&(_=>d[_])).call(je,this,i)).node()}};function s0(e){return e==null?null:un(e,"textOverflow",["clip","ellipsis","clip-start","clip-end","ellipsis-start","ellipsis-middle","ellipsis-end"]).replace(/^(clip|ellipsis)$/,"$1-end")}function dN(e,t,n,i){if(!n)return;let{lineAnchor:r,lineHeight:s,textOverflow:o,splitLines:a,clipLine:c}=t;e.each(function(l){let u=a(Vi(n[l])??"").map(c),h=u.length,f=r==="top"?.71:r==="bottom"?1-h:(164-h*100)/200;if(h>1){let d=0;for(let m=0;m<h;++m){if(++d,!u[m])continue;let y=this.ownerDocument.createElementNS(Lr.svg,"tspan");y.setAttribute("x",0),m===d-1?y.setAttribute("y",`${(f+m)*s}em`):y.setAttribute("dy",`${d*s}em`),y.textContent=u[m],this.appendChild(y),d=0}}else f&&this.setAttribute("y",`${f*s}em`),this.textContent=u[0];if(o&&!i&&u[0]!==n[l]){let d=this.ownerDocument.createElementNS(Lr.svg,"title");d.textContent=n[l],this.appendChild(d)}})}function dr(e,{x:t,y:n,...i}={}){return i.frameAnchor===void 0&&([t,n]=Zn(t,n)),new ca(e,{...i,x:t,y:n})}function o0(e,{x:t=fe,...n}={}){return new ca(e,HS({...n,x:t}))}function a0(e,{y:t=fe,...n}={}){return new ca(e,VS({...n,y:t}))}function c0(e,t,n){Ft(e,"text-anchor",t.textAnchor),Ft(e,"font-family",t.fontFamily),Ft(e,"font-size",t.fontSize),Ft(e,"font-style",t.fontStyle),Ft(e,"font-variant",t.fontVariant===void 0?pN(n):t.fontVariant),Ft(e,"font-weight",t.fontWeight)}function pN(e){return e&&(ZM(e)||Re(e))?"tabular-nums":void 0}var mN=new Set(["inherit","initial","revert","unset","xx-small","x-small","small","medium","large","x-large","xx-large","xxx-large","larger","smaller"]);function gN(e){return e==null||typeof e=="number"?[void 0,e]:typeof e!="string"?[e,void 0]:(e=e.trim().toLowerCase(),mN.has(e)||/^[+-]?\d*\.?\d+(e[+-]?\d+)?(\w*|%)$/.test(e)?[void 0,e]:[e,void 0])}function yN(e,t,n){let i=[],r,s=0;for(let[o,a,c]of xN(e)){if(r===void 0&&(r=o),s>r&&n(e,r,a)>t&&(i.push(e.slice(r,s)+(e[s-1]===ZS?"-":"")),r=o),c){i.push(e.slice(r,a)),r=void 0;continue}s=a}return i}function*xN(e){let t=0,n=0,i=e.length;for(;n<i;){let r=1;switch(e[n]){case ZS:case"-":++n,yield[t,n,!1],t=n;break;case" ":for(yield[t,n,!1];e[++n]===" ";);t=n;break;case"\r":e[n+1]===`
`&&++r;case`
`:yield[t,n,!0],n+=r,t=n;break;default:++n;break}}yield[t,n,!0]}var $S={a:56,b:63,c:57,d:63,e:58,f:37,g:62,h:60,i:26,j:26,k:55,l:26,m:88,n:60,o:60,p:62,q:62,r:39,s:54,t:38,u:60,v:55,w:79,x:54,y:55,z:55,A:69,B:67,C:73,D:74,E:61,F:58,G:76,H:75,I:28,J:55,K:67,L:58,M:89,N:75,O:78,P:65,Q:78,R:67,S:65,T:65,U:75,V:69,W:98,X:69,Y:67,Z:67,0:64,1:48,2:62,3:64,4:66,5:63,6:65,7:58,8:65,9:65," ":29,"!":32,'"':49,"'":31,"(":39,")":39,",":31,"-":48,".":31,"/":32,":":31,";":31,"?":52,"‘":31,"’":31,"“":47,"”":47,"…":82};function rf(e,t=0,n=e.length){let i=0;for(let r=t;r<n;r=la(e,r))i+=$S[e[r]]??(KS(e,r)?120:$S.e);return i}function sf(e,t=0,n=e.length){let i=0;for(let r=t;r<n;r=la(e,r))i+=KS(e,r)?126:63;return i}function l0({monospace:e,lineWidth:t,textOverflow:n}){if(n!=null||t==1/0)return s=>s.split(/\r\n?|\n/g);let i=e?sf:rf,r=t*100;return s=>yN(s,r,i)}function u0({monospace:e,lineWidth:t,textOverflow:n}){if(n==null||t==1/0)return s=>s;let i=e?sf:rf,r=t*100;switch(n){case"clip-start":return s=>YS(s,r,i,"");case"clip-end":return s=>XS(s,r,i,"");case"ellipsis-start":return s=>YS(s,r,i,Xs);case"ellipsis-middle":return s=>_N(s,r,i,Xs);case"ellipsis-end":return s=>XS(s,r,i,Xs)}}var Xs="…";function Ys(e,t,n,i){let r=[],s=0;for(let o=0,a=0,c=e.length;o<c;o=a){a=la(e,o);let l=n(e,o,a);if(s+l>t){for(s+=i;s>t&&o>0;)a=o,o=r.pop(),s-=n(e,o,a);return[o,t-s]}s+=l,r.push(o)}return[-1,0]}function XS(e,t,n,i){e=e.trim();let r=n(i),[s]=Ys(e,t,n,r);return s<0?e:e.slice(0,s).trimEnd()+i}function _N(e,t,n,i){e=e.trim();let r=n(e);if(r<=t)return e;let s=n(i)/2,[o,a]=Ys(e,t/2,n,s),[c]=Ys(e,r-t/2-a+s,n,-s);return c<0?i:e.slice(0,o).trimEnd()+i+e.slice(la(e,c)).trimStart()}function YS(e,t,n,i){e=e.trim();let r=n(e);if(r<=t)return e;let s=n(i),[o]=Ys(e,r-t+s,n,-s);return o<0?i:i+e.slice(la(e,o)).trimStart()}var r0=/[\p{Combining_Mark}\p{Emoji_Modifier}]+/uy,qS=/\p{Extended_Pictographic}/uy;function la(e,t){return t+=vN(e,t)?2:1,MN(e,t)&&(t=r0.lastIndex),bN(e,t)?la(e,t+1):t}function JS(e,t){return e.charCodeAt(t)<128}function vN(e,t){let n=e.charCodeAt(t);if(n>=55296&&n<56320){let i=e.charCodeAt(t+1);return i>=56320&&i<57344}return!1}function bN(e,t){return e.charCodeAt(t)===8205}function MN(e,t){return JS(e,t)?!1:(r0.lastIndex=t,r0.test(e))}function KS(e,t){return JS(e,t)?!1:(qS.lastIndex=t,qS.test(e))}var wN={ariaLabel:"vector",fill:"none",stroke:"currentColor",strokeWidth:1.5,strokeLinejoin:"round",strokeLinecap:"round"},jS=3.5,SN=jS*5,QS={draw(e,t,n){let i=t*n/SN;e.moveTo(0,0),e.lineTo(0,-t),e.moveTo(-i,i-t),e.lineTo(0,-t),e.lineTo(i,i-t)}},TN={draw(e,t,n){e.moveTo(-n,0),e.lineTo(0,-t),e.lineTo(n,0)}},EN=new Map([["arrow",QS],["spike",TN]]);function AN(e){return e&&typeof e.draw=="function"}function CN(e){if(AN(e))return e;let t=EN.get(`${e}`.toLowerCase());if(t)return t;throw new Error(`invalid shape: ${e}`)}var of=class extends de{constructor(t,n={}){let{x:i,y:r,r:s=jS,length:o,rotate:a,shape:c=QS,anchor:l="middle",frameAnchor:u}=n,[h,f]=Ae(o,12),[d,m]=Ae(a,0);super(t,{x:{value:i,scale:"x",optional:!0},y:{value:r,scale:"y",optional:!0},length:{value:h,scale:"length",optional:!0},rotate:{value:d,optional:!0}},n,wN),this.r=+s,this.length=f,this.rotate=m,this.shape=CN(c),this.anchor=un(l,"anchor",["start","middle","end"]),this.frameAnchor=$r(u)}render(t,n,i,r,s){let{x:o,y:a}=n,{x:c,y:l,length:u,rotate:h}=i,{length:f,rotate:d,anchor:m,shape:y,r:g}=this,[p,_]=Hi(this,r);return te("svg:g",s).call(Le,this,r,s).call(we,this,{x:c&&o,y:l&&a}).call(b=>b.selectAll().data(t).enter().append("path").call(Me,this).attr("transform",aa`translate(${c?x=>c[x]:p},${l?x=>l[x]:_})${h?x=>` rotate(${h[x]})`:d?` rotate(${d})`:""}${m==="start"?"":m==="end"?u?x=>` translate(0,${u[x]})`:` translate(0,${f})`:u?x=>` translate(0,${u[x]/2})`:` translate(0,${f/2})`}`).attr("d",u?x=>{let C=Ti();return y.draw(C,u[x],g),C}:(()=>{let x=Ti();return y.draw(x,f,g),x})()).call(je,this,i)).node()}};function t2(e,t={}){let{x:n=fe,...i}=t;return new of(e,{...i,x:n})}function e2(e,t={}){let{y:n=fe,...i}=t;return new of(e,{...i,y:n})}function qr(e,t){return arguments.length<2&&!xn(e)&&(t=e,e=null),t===void 0&&(t={}),[e,t]}function af({anchor:e}={},t){return e===void 0?t[0]:un(e,"anchor",t)}function n2(e){return af(e,["left","right"])}function i2(e){return af(e,["right","left"])}function r2(e){return af(e,["bottom","top"])}function s2(e){return af(e,["top","bottom"])}function h0(){let[e,t]=qr(...arguments);return c2("y",n2(t),e,t)}function o2(){let[e,t]=qr(...arguments);return c2("fy",i2(t),e,t)}function d0(){let[e,t]=qr(...arguments);return l2("x",r2(t),e,t)}function a2(){let[e,t]=qr(...arguments);return l2("fx",s2(t),e,t)}function c2(e,t,n,{color:i="currentColor",opacity:r=1,stroke:s=i,strokeOpacity:o=r,strokeWidth:a=1,fill:c=i,fillOpacity:l=r,textAnchor:u,textStroke:h,textStrokeOpacity:f,textStrokeWidth:d,tickSize:m=e==="y"?6:0,tickPadding:y,tickRotate:g,x:p,margin:_,marginTop:b=_===void 0?20:_,marginRight:x=_===void 0?t==="right"?40:0:_,marginBottom:C=_===void 0?20:_,marginLeft:w=_===void 0?t==="left"?40:0:_,label:S,labelAnchor:R,labelArrow:M,labelOffset:v,ariaLabel:E=`${e}-axis`,...N}){return m=Pe(m),y=Pe(y),g=Pe(g),R!==void 0&&(R=un(R,"labelAnchor",["center","top","bottom"])),M=b2(M),Yg(m&&!Xe(s)?RN(e,t,n,{stroke:s,strokeOpacity:o,strokeWidth:a,tickSize:m,tickPadding:y,tickRotate:g,x:p,ariaLabel:E,...N}):null,Xe(c)?null:PN(e,t,n,{fill:c,fillOpacity:l,stroke:h,strokeOpacity:f,strokeWidth:d,textAnchor:u,tickSize:m,tickPadding:y,tickRotate:g,x:p,marginTop:b,marginRight:x,marginBottom:C,marginLeft:w,ariaLabel:E,...N}),!Xe(c)&&S!==null?dr([],y2({fill:c,fillOpacity:l,...N},function(U,F,P,O,H){let z=O[e],{marginTop:G,marginRight:j,marginBottom:nt,marginLeft:ct}=e==="y"&&H.inset||H,ft=R??(z.bandwidth?"center":"top"),$=v??(t==="right"?j:ct)-3;return ft==="center"?(this.textAnchor=void 0,this.lineAnchor=t==="right"?"bottom":"top",this.frameAnchor=t,this.rotate=-90):(this.textAnchor=t==="right"?"end":"start",this.lineAnchor=ft,this.frameAnchor=`${ft}-${t}`,this.rotate=0),this.dy=ft==="top"?3-G:ft==="bottom"?nt-3:0,this.dx=t==="right"?$:-$,this.ariaLabel=`${E} label`,{facets:[[0]],channels:{text:{value:[v2(e,z,{anchor:t,label:S,labelAnchor:ft,labelArrow:M})]}}}})):null)}function l2(e,t,n,{color:i="currentColor",opacity:r=1,stroke:s=i,strokeOpacity:o=r,strokeWidth:a=1,fill:c=i,fillOpacity:l=r,textAnchor:u,textStroke:h,textStrokeOpacity:f,textStrokeWidth:d,tickSize:m=e==="x"?6:0,tickPadding:y,tickRotate:g,y:p,margin:_,marginTop:b=_===void 0?t==="top"?30:0:_,marginRight:x=_===void 0?20:_,marginBottom:C=_===void 0?t==="bottom"?30:0:_,marginLeft:w=_===void 0?20:_,label:S,labelAnchor:R,labelArrow:M,labelOffset:v,ariaLabel:E=`${e}-axis`,...N}){return m=Pe(m),y=Pe(y),g=Pe(g),R!==void 0&&(R=un(R,"labelAnchor",["center","left","right"])),M=b2(M),Yg(m&&!Xe(s)?IN(e,t,n,{stroke:s,strokeOpacity:o,strokeWidth:a,tickSize:m,tickPadding:y,tickRotate:g,y:p,ariaLabel:E,...N}):null,Xe(c)?null:LN(e,t,n,{fill:c,fillOpacity:l,stroke:h,strokeOpacity:f,strokeWidth:d,textAnchor:u,tickSize:m,tickPadding:y,tickRotate:g,y:p,marginTop:b,marginRight:x,marginBottom:C,marginLeft:w,ariaLabel:E,...N}),!Xe(c)&&S!==null?dr([],y2({fill:c,fillOpacity:l,...N},function(U,F,P,O,H){let z=O[e],{marginTop:G,marginRight:j,marginBottom:nt,marginLeft:ct}=e==="x"&&H.inset||H,ft=R??(z.bandwidth?"center":"right"),$=v??(t==="top"?G:nt)-3;return ft==="center"?(this.frameAnchor=t,this.textAnchor=void 0):(this.frameAnchor=`${t}-${ft}`,this.textAnchor=ft==="right"?"end":"start"),this.lineAnchor=t,this.dy=t==="top"?-$:$,this.dx=ft==="right"?j-3:ft==="left"?3-ct:0,this.ariaLabel=`${E} label`,{facets:[[0]],channels:{text:{value:[v2(e,z,{anchor:t,label:S,labelAnchor:ft,labelArrow:M})]}}}})):null)}function RN(e,t,n,{strokeWidth:i=1,strokeLinecap:r=null,strokeLinejoin:s=null,facetAnchor:o=t+(e==="y"?"-empty":""),frameAnchor:a=t,tickSize:c,inset:l=0,insetLeft:u=l,insetRight:h=l,dx:f=0,y:d=e==="y"?void 0:null,ariaLabel:m,...y}){return ua(e2,e,n,{ariaLabel:`${m} tick`,ariaHidden:!0},{strokeWidth:i,strokeLinecap:r,strokeLinejoin:s,facetAnchor:o,frameAnchor:a,y:d,...y,dx:t==="left"?+f-Ke+ +u:+f+Ke-h,anchor:"start",length:c,shape:t==="left"?FN:ON})}function IN(e,t,n,{strokeWidth:i=1,strokeLinecap:r=null,strokeLinejoin:s=null,facetAnchor:o=t+(e==="x"?"-empty":""),frameAnchor:a=t,tickSize:c,inset:l=0,insetTop:u=l,insetBottom:h=l,dy:f=0,x:d=e==="x"?void 0:null,ariaLabel:m,...y}){return ua(t2,e,n,{ariaLabel:`${m} tick`,ariaHidden:!0},{strokeWidth:i,strokeLinejoin:s,strokeLinecap:r,facetAnchor:o,frameAnchor:a,x:d,...y,dy:t==="bottom"?+f-Ke-h:+f+Ke+ +u,anchor:"start",length:c,shape:t==="bottom"?DN:UN})}function PN(e,t,n,{facetAnchor:i=t+(e==="y"?"-empty":""),frameAnchor:r=t,tickSize:s,tickRotate:o=0,tickPadding:a=Math.max(3,9-s)+(Math.abs(o)>60?4*Math.cos(o*jg):0),text:c,textAnchor:l=Math.abs(o)>60?"middle":t==="left"?"end":"start",lineAnchor:u=o>60?"top":o<-60?"bottom":"middle",fontVariant:h,inset:f=0,insetLeft:d=f,insetRight:m=f,dx:y=0,ariaLabel:g,y:p=e==="y"?void 0:null,..._}){return ua(a0,e,n,{ariaLabel:`${g} tick label`},{facetAnchor:i,frameAnchor:r,text:c,textAnchor:l,lineAnchor:u,fontVariant:h,rotate:o,y:p,..._,dx:t==="left"?+y-s-a+ +d:+y+ +s+ +a-m},function(b,x,C,w,S){h===void 0&&(this.fontVariant=_2(b)),c===void 0&&(S.text=x2(b,x,C,w,t))})}function LN(e,t,n,{facetAnchor:i=t+(e==="x"?"-empty":""),frameAnchor:r=t,tickSize:s,tickRotate:o=0,tickPadding:a=Math.max(3,9-s)+(Math.abs(o)>=10?4*Math.cos(o*jg):0),text:c,textAnchor:l=Math.abs(o)>=10?o<0^t==="bottom"?"start":"end":"middle",lineAnchor:u=Math.abs(o)>=10?"middle":t==="bottom"?"top":"bottom",fontVariant:h,inset:f=0,insetTop:d=f,insetBottom:m=f,dy:y=0,x:g=e==="x"?void 0:null,ariaLabel:p,..._}){return ua(o0,e,n,{ariaLabel:`${p} tick label`},{facetAnchor:i,frameAnchor:r,text:c===void 0?null:c,textAnchor:l,lineAnchor:u,fontVariant:h,rotate:o,x:g,..._,dy:t==="bottom"?+y+ +s+ +a-m:+y-s-a+ +d},function(b,x,C,w,S){h===void 0&&(this.fontVariant=_2(b)),c===void 0&&(S.text=x2(b,x,C,w,t))})}function u2(){let[e,t]=qr(...arguments);return p2("y",n2(t),e,t)}function f2(){let[e,t]=qr(...arguments);return p2("fy",i2(t),e,t)}function h2(){let[e,t]=qr(...arguments);return m2("x",r2(t),e,t)}function d2(){let[e,t]=qr(...arguments);return m2("fx",s2(t),e,t)}function p2(e,t,n,{y:i=e==="y"?void 0:null,x:r=null,x1:s=t==="left"?r:null,x2:o=t==="right"?r:null,ariaLabel:a=`${e}-grid`,ariaHidden:c=!0,...l}){return ua($s,e,n,{ariaLabel:a,ariaHidden:c},{y:i,x1:s,x2:o,...g2(l)})}function m2(e,t,n,{x:i=e==="x"?void 0:null,y:r=null,y1:s=t==="top"?r:null,y2:o=t==="bottom"?r:null,ariaLabel:a=`${e}-grid`,ariaHidden:c=!0,...l}){return ua(Yr,e,n,{ariaLabel:a,ariaHidden:c},{x:i,y1:s,y2:o,...g2(l)})}function g2({color:e="currentColor",opacity:t=.1,stroke:n=e,strokeOpacity:i=t,strokeWidth:r=1,...s}){return{stroke:n,strokeOpacity:i,strokeWidth:r,...s}}function y2({fill:e,fillOpacity:t,fontFamily:n,fontSize:i,fontStyle:r,fontVariant:s,fontWeight:o,monospace:a,pointerEvents:c,shapeRendering:l,clip:u=!1},h){return[,e]=ln(e),[,t]=Ae(t),{facet:"super",x:null,y:null,fill:e,fillOpacity:t,fontFamily:n,fontSize:i,fontStyle:r,fontVariant:s,fontWeight:o,monospace:a,pointerEvents:c,shapeRendering:l,clip:u,initializer:h}}function ua(e,t,n,i,r,s){let o;function a(u,h,f,d,m,y){let g=u==null&&(t==="fx"||t==="fy"),{[t]:p}=d;if(!p)throw new Error(`missing scale: ${t}`);let _=p.domain(),{interval:b,ticks:x,tickFormat:C,tickSpacing:w=t==="x"?80:35}=r;if(typeof x=="string"&&M2(p)&&(b=x,x=void 0),x===void 0&&(x=Bi(b,p.type)??NN(p,w)),u==null){if(xn(x))u=Oi(x);else if(Wr(x))u=f0(x,...Je(_));else if(p.interval){let R=p.interval;if(p.ticks){let[M,v]=Je(_),E=(v-M)/R[Ho];R=eg(R,E/x)??R,u=f0(R,M,v)}else{u=_;let M=u.length;R=eg(R,M/x)??R,R!==p.interval&&(u=f0(R,...Je(u)))}if(R===p.interval){let M=Math.round(u.length/x);M>1&&(u=u.filter((v,E)=>E%M===0))}}else p.ticks?u=p.ticks(x):u=_;if(!p.ticks&&u.length&&u!==_){let R=new Mi(_);u=u.filter(M=>R.has(M)),u.length||_n(`Warning: the ${t}-axis ticks appear to not align with the scale domain, resulting in no ticks. Try different ticks?`)}t==="y"||t==="x"?h=[fn(u)]:o[t]={scale:t,value:fe}}s?.call(this,p,u,x,C,o);let S=Object.fromEntries(Object.entries(o).map(([R,M])=>[R,{...M,value:ve(u,M.value)}]));return g&&(h=y.filterFacets(u,S)),{data:u,facets:h,channels:S}}let c=cr(r).initializer,l=e(n,cr({...r,initializer:a},c));return n==null?(o=l.channels,l.channels={}):o={},i!==void 0&&Object.assign(l,i),l.clip===void 0&&(l.clip=!1),l}function NN(e,t){let[n,i]=Je(e.range());return(i-n)/t}function x2(e,t,n,i,r){return{value:$c(e,t,n,i,r)}}function $c(e,t,n,i,r){return typeof i=="function"&&!(e.type==="log"&&e.tickFormat)?i:i===void 0&&t&&Re(t)?PM(e.type,t,r)??Vi:e.tickFormat?e.tickFormat(typeof n=="number"?n:null,i):typeof i=="string"&&e.domain().length>0?(Re(e.domain())?Li:Ei)(i):i===void 0?Vi:An(i)}function f0(e,t,n){return e.range(t,e.offset(e.floor(n)))}var DN={draw(e,t){e.moveTo(0,0),e.lineTo(0,t)}},UN={draw(e,t){e.moveTo(0,0),e.lineTo(0,-t)}},FN={draw(e,t){e.moveTo(0,0),e.lineTo(-t,0)}},ON={draw(e,t){e.moveTo(0,0),e.lineTo(t,0)}};function _2(e){return e.bandwidth&&!e.interval?void 0:"tabular-nums"}function v2(e,t,{anchor:n,label:i=t.label,labelAnchor:r,labelArrow:s}={}){if(!(i==null||i.inferred&&M2(t)&&/^(date|time|year)$/i.test(i))){if(i=String(i),s==="auto"&&(s=(!t.bandwidth||t.interval)&&!/[↑↓→←]/.test(i)),!s)return i;if(s===!0){let o=sS(t);o&&(s=/x$/.test(e)||r==="center"?/x$/.test(e)===o<0?"left":"right":o<0?"up":"down")}switch(s){case"left":return`← ${i}`;case"right":return`${i} →`;case"up":return n==="right"?`${i} ↑`:`↑ ${i}`;case"down":return n==="right"?`${i} ↓`:`↓ ${i}`}return i}}function b2(e="auto"){return Xe(e)?!1:typeof e=="boolean"?e:un(e,"labelArrow",["auto","up","right","down","left"])}function M2(e){return Re(e.domain())}function w2(e,t){if(t==null)return t;let n=e(t);if(!n)throw new Error(`scale not found: ${t}`);return n}function S2(e,{opacity:t,...n}={}){if(!zi(e)&&!kg(e))throw new Error(`swatches legend requires ordinal or threshold color scale (not ${e.type})`);return E2(e,n,(i,r,s,o)=>i.append("svg").attr("width",s).attr("height",o).attr("fill",r.scale).attr("fill-opacity",Ae(t)[1]).append("rect").attr("width","100%").attr("height","100%"))}function T2(e,{fill:t=e.hint?.fill!==void 0?e.hint.fill:"none",fillOpacity:n=1,stroke:i=e.hint?.stroke!==void 0?e.hint.stroke:Xe(t)?"currentColor":"none",strokeOpacity:r=1,strokeWidth:s=1.5,r:o=4.5,...a}={},c){let[l,u]=ln(t),[h,f]=ln(i),d=w2(c,l),m=w2(c,h),y=o*o*Math.PI;return n=Ae(n)[1],r=Ae(r)[1],s=Ae(s)[1],E2(e,a,(g,p,_,b)=>g.append("svg").attr("viewBox","-8 -8 16 16").attr("width",_).attr("height",b).attr("fill",l==="color"?x=>d.scale(x):u).attr("fill-opacity",n).attr("stroke",h==="color"?x=>m.scale(x):f).attr("stroke-opacity",r).attr("stroke-width",s).append("path").attr("d",x=>{let C=Ti();return e.scale(x).draw(C,y),C}))}function E2(e,t={},n){let{columns:i,tickFormat:r,fontVariant:s=ju(e),swatchSize:o=15,swatchWidth:a=o,swatchHeight:c=o,marginLeft:l=0,className:u,style:h,width:f}=t,d=ia(t);u=ra(u),r=$c(e.scale,e.domain,void 0,r);let m=te("div",d).attr("class",`${u}-swatches ${u}-swatches-${i!=null?"columns":"wrap"}`),y;return i!=null?(y=`:where(.${u}-swatches-columns .${u}-swatch) {
  display: flex;
  align-items: center;
  break-inside: avoid;
  padding-bottom: 1px;
}
:where(.${u}-swatches-columns .${u}-swatch::before) {
  flex-shrink: 0;
}
:where(.${u}-swatches-columns .${u}-swatch-label) {
  white-space: nowrap;
  overflow: hidden;
  text-overflow: ellipsis;
}`,m.style("columns",i).selectAll().data(e.domain).enter().append("div").attr("class",`${u}-swatch`).call(n,e,a,c).call(g=>g.append("div").attr("class",`${u}-swatch-label`).attr("title",r).text(r))):(y=`:where(.${u}-swatches-wrap) {
  display: flex;
  align-items: center;
  min-height: 33px;
  flex-wrap: wrap;
}
:where(.${u}-swatches-wrap .${u}-swatch) {
  display: inline-flex;
  align-items: center;
  margin-right: 1em;
}`,m.selectAll().data(e.domain).enter().append("span").attr("class",`${u}-swatch`).call(n,e,a,c).append(function(){return this.ownerDocument.createTextNode(r.apply(this,arguments))})),m.call(g=>g.insert("style","*").text(`:where(.${u}-swatches) {
  font-family: system-ui, sans-serif;
  font-size: 10px;
  margin-bottom: 0.5em;
}
:where(.${u}-swatch > svg) {
  margin-right: 0.5em;
  overflow: visible;
}
${y}`)).style("margin-left",l?`${+l}px`:null).style("width",f===void 0?null:`${+f}px`).style("font-variant",Ce(s,"normal")).call(sa,h).node()}var p0=new Map([["symbol",T2],["color",R2],["opacity",BN]]);function A2(e,t,n={}){return(i,r)=>{if(!p0.has(i))throw new Error(`unknown legend type: ${i}`);if(i in e)return p0.get(i)(e[i],C2(t,n[i],r),s=>e[s])}}function C2({className:e,...t},{label:n,ticks:i,tickFormat:r}={},s){return jM(s,{className:e,...t},{label:n,ticks:i,tickFormat:r})}function R2(e,{legend:t=!0,...n}){if(t===!0&&(t=e.type==="ordinal"?"swatches":"ramp"),e.domain!==void 0)switch(`${t}`.toLowerCase()){case"swatches":return S2(e,n);case"ramp":return IS(e,n);default:throw new Error(`unknown legend type: ${t}`)}}function BN({type:e,interpolate:t,...n},{legend:i=!0,color:r=ai(0,0,0),...s}){if(!t)throw new Error(`${e} opacity scales are not supported`);if(i===!0&&(i="ramp"),`${i}`.toLowerCase()!=="ramp")throw new Error(`${i} opacity legends are not supported`);return R2({type:e,...n,interpolate:kN(r)},{legend:i,...s})}function kN(e){let{r:t,g:n,b:i}=ai(e)||ai(0,0,0);return r=>`rgba(${t},${n},${i},${r})`}function I2(e,t,n){let i=[];for(let[r,s]of p0){let o=n[r];if(o?.legend&&r in e){let a=s(e[r],C2(t,e[r],o),c=>e[c]);a!=null&&i.push(a)}}return i}function cf(e={},t="y"){return fg(e)?e:{...e,[t]:fe}}function P2(e,t){if(t.length===1)return{data:e,facets:t};let n=Gr(e),i=new Uint8Array(n),r=0;for(let a of t)for(let c of a)i[c]&&++r,i[c]=1;if(r===0)return{data:e,facets:t};e=Vr(e);let s=e[rg]=new Uint32Array(n+r);t=t.map(a=>Vr(a,Uint32Array));let o=n;i.fill(0);for(let a of t)for(let c=0,l=a.length;c<l;++c){let u=a[c];i[u]?(a[c]=o,e[o]=e[u],s[o]=u,++o):s[u]=u,i[u]=1}return{data:e,facets:t}}function zN(e={},t={}){arguments.length===1&&([e,t]=VN(e));let{x1:n,x:i=n,y:r,...s}=t,[o,a,c,l]=GN(i,r,"x","y",e,s);return{...o,x1:n,x:a,y1:c,y2:l,y:Lc(c,l)}}function lf({y:e,y1:t,y2:n,...i}={}){return i=Ws(i,"x"),t===void 0&&n===void 0?zN({y:e,...i}):([t,n]=VM(e,t,n),{...i,y1:t,y2:n})}function VN(e){let{offset:t,order:n,reverse:i,...r}=e;return[{offset:t,order:n,reverse:i},r]}var HN={length:!0};function GN(e,t=FM,n,i,{offset:r,order:s,reverse:o},a){if(t===null)throw new Error(`stack requires ${i}`);let c=Xo(a),[l,u]=Kn(e),[h,f]=Yo(t),[d,m]=Yo(t);return h.hint=d.hint=HN,r=WN(r),s=YN(s,r,i),[Gs(a,(y,g,p)=>{({data:y,facets:g}=P2(y,g));let _=e==null?void 0:u(Nc(ve(y,e),p?.[n])),b=ve(y,t,Float64Array),x=ve(y,c),C=s&&s(y,_,b,x),w=Gr(y),S=f(new Float64Array(w)),R=m(new Float64Array(w)),M=[];for(let v of g){let E=_?Array.from(ms(v,N=>_[N]).values()):[v];if(C)for(let N of E)N.sort(C);for(let N of E){let U=0,F=0;o&&N.reverse();for(let P of N){let O=b[P];O<0?U=R[P]=(S[P]=U)+O:O>0?F=R[P]=(S[P]=F)+O:R[P]=S[P]=F}}M.push(E)}return r&&r(M,S,R,x),{data:y,facets:g}}),l,h,d]}function WN(e){if(e!=null){if(typeof e=="function")return e;switch(`${e}`.toLowerCase()){case"expand":case"normalize":return $N;case"center":case"silhouette":return XN;case"wiggle":return U2}throw new Error(`unknown offset: ${e}`)}}function D2(e,t){let n=0,i=0;for(let r of e){let s=t[r];s<n&&(n=s),s>i&&(i=s)}return[n,i]}function $N(e,t,n){for(let i of e)for(let r of i){let[s,o]=D2(r,n);for(let a of r){let c=1/(o-s||1);t[a]=c*(t[a]-s),n[a]=c*(n[a]-s)}}}function XN(e,t,n){for(let i of e){for(let r of i){let[s,o]=D2(r,n);for(let a of r){let c=(o+s)/2;t[a]-=c,n[a]-=c}}F2(i,t,n)}O2(e,t,n)}function U2(e,t,n,i){for(let r of e){let s=new On,o=0;for(let a of r){let c=-1,l=a.map(d=>Math.abs(n[d]-t[d])),u=a.map(d=>{c=i?i[d]:++c;let m=n[d]-t[d],y=s.has(c)?m-s.get(c):0;return s.set(c,m),y}),h=[0,...d_(u)];for(let d of a)t[d]+=o,n[d]+=o;let f=ri(l);f&&(o-=ri(l,(d,m)=>(u[m]/2+h[m])*d)/f)}F2(r,t,n)}O2(e,t,n)}function F2(e,t,n){let i=Bn(e,r=>Bn(r,s=>t[s]));for(let r of e)for(let s of r)t[s]-=i,n[s]-=i}function O2(e,t,n){let i=e.length;if(i===1)return;let r=e.map(a=>a.flat()),s=r.map(a=>(Bn(a,c=>t[c])+sn(a,c=>n[c]))/2),o=Bn(s);for(let a=0;a<i;a++){let c=o-s[a];for(let l of r[a])t[l]+=c,n[l]+=c}}function YN(e,t,n){if(e===void 0&&t===U2)return L2(en);if(e!=null){if(typeof e=="string"){let i=e.startsWith("-"),r=i?Fs:en;switch((i?e.slice(1):e).toLowerCase()){case"value":case n:return qN(r);case"z":return ZN(r);case"sum":return JN(r);case"appearance":return KN(r);case"inside-out":return L2(r)}return N2(og(e))}if(typeof e=="function")return(e.length===1?N2:jN)(e);if(ci(e))return QN(e);throw new Error(`invalid order: ${e}`)}}function qN(e){return(t,n,i)=>(r,s)=>e(i[r],i[s])}function ZN(e){return(t,n,i,r)=>(s,o)=>e(r[s],r[o])}function JN(e){return uf(e,(t,n,i,r)=>wl(fn(t),s=>ri(s,o=>i[o]),s=>r[s]))}function KN(e){return uf(e,(t,n,i,r)=>wl(fn(t),s=>n[Qh(s,o=>i[o])],s=>r[s]))}function L2(e){return uf(e,(t,n,i,r)=>{let s=fn(t),o=wl(s,h=>n[Qh(h,f=>i[f])],h=>r[h]),a=Ji(s,h=>ri(h,f=>i[f]),h=>r[h]),c=[],l=[],u=0;for(let h of o)u<0?(u+=a.get(h),c.push(h)):(u-=a.get(h),l.push(h));return l.reverse().concat(c)})}function N2(e){return t=>{let n=ve(t,e);return(i,r)=>en(n[i],n[r])}}function jN(e){return t=>ci(t)?(n,i)=>e(t[n],t[i]):(n,i)=>e(t.get(n),t.get(i))}function QN(e){return uf(en,()=>e)}function uf(e,t){return(n,i,r,s)=>{if(!s)throw new Error("missing channel: z");let o=new On(t(n,i,r,s).map((a,c)=>[a,c]));return(a,c)=>e(o.get(s[a]),o.get(s[c]))}}var tD={ariaLabel:"rect"},df=class extends de{constructor(t,n={}){let{x1:i,y1:r,x2:s,y2:o}=n;super(t,{x1:{value:i,scale:"x",type:i!=null&&s==null?"band":void 0,optional:!0},y1:{value:r,scale:"y",type:r!=null&&o==null?"band":void 0,optional:!0},x2:{value:s,scale:"x",optional:!0},y2:{value:o,scale:"y",optional:!0}},n,tD),Xc(this,n),Yc(this,n)}render(t,n,i,r,s){let{x:o,y:a}=n,{x1:c,y1:l,x2:u,y2:h}=i,{marginTop:f,marginRight:d,marginBottom:m,marginLeft:y,width:g,height:p}=r,{projection:_}=s,{insetTop:b,insetRight:x,insetBottom:C,insetLeft:w}=this,{rx:S,ry:R,rx1y1:M,rx1y2:v,rx2y1:E,rx2y2:N}=this;(c||u)&&!_&&hi(o)&&(c=u=null),(l||h)&&!_&&hi(a)&&(l=h=null);let U=o?.bandwidth?o.bandwidth():0,F=a?.bandwidth?a.bandwidth():0;return te("svg:g",s).call(Le,this,r,s).call(we,this,{},0,0).call(P=>P.selectAll().data(t).enter().call(M||v||E||N?O=>O.append("path").call(Me,this).call(qc,c&&u?H=>c[H]+(u[H]<c[H]?-x:w):c?H=>c[H]+w:y+w,l&&h?H=>l[H]+(h[H]<l[H]?-C:b):l?H=>l[H]+b:f+b,c&&u?H=>u[H]-(u[H]<c[H]?-w:x):c?H=>c[H]+U-x:g-d-x,l&&h?H=>h[H]-(h[H]<l[H]?-b:C):l?H=>l[H]+F-C:p-m-C,this).call(je,this,i):O=>O.append("rect").call(Me,this).attr("x",c?u?H=>Math.min(c[H],u[H])+w:H=>c[H]+w:y+w).attr("y",l?h?H=>Math.min(l[H],h[H])+b:H=>l[H]+b:f+b).attr("width",c?u?H=>Math.max(0,Math.abs(u[H]-c[H])+U-w-x):U-w-x:g-d-y-x-w).attr("height",l?h?H=>Math.max(0,Math.abs(l[H]-h[H])+F-b-C):F-b-C:p-f-m-b-C).call(Ft,"rx",S).call(Ft,"ry",R).call(je,this,i))).node()}};function Xc(e,{inset:t=0,insetTop:n=t,insetRight:i=t,insetBottom:r=t,insetLeft:s=t}={}){e.insetTop=Pe(n),e.insetRight=Pe(i),e.insetBottom=Pe(r),e.insetLeft=Pe(s)}function Yc(e,{r:t,rx:n,ry:i,rx1:r=t,ry1:s=t,rx2:o=t,ry2:a=t,rx1y1:c=r!==void 0?+r:s!==void 0?+s:0,rx1y2:l=r!==void 0?+r:a!==void 0?+a:0,rx2y1:u=o!==void 0?+o:s!==void 0?+s:0,rx2y2:h=o!==void 0?+o:a!==void 0?+a:0}={}){c||l||u||h?(e.rx1y1=c,e.rx1y2=l,e.rx2y1=u,e.rx2y2=h):(e.rx=Ce(n,"auto"),e.ry=Ce(i,"auto"))}function qc(e,t,n,i,r,s){let{rx1y1:o,rx1y2:a,rx2y1:c,rx2y2:l}=s;typeof t!="function"&&(t=An(t)),typeof n!="function"&&(n=An(n)),typeof i!="function"&&(i=An(i)),typeof r!="function"&&(r=An(r));let u=Math.max(Math.abs(o+c),Math.abs(a+l)),h=Math.max(Math.abs(o+a),Math.abs(c+l));e.attr("d",f=>{let d=t(f),m=n(f),y=i(f),g=r(f),p=d>y,_=m>g,b=p?y:d,x=p?d:y,C=_?g:m,w=_?m:g,S=Math.min(1,(x-b)/u,(w-C)/h),R=S*(p?_?l:c:_?a:o),M=S*(p?_?a:o:_?l:c),v=S*(p?_?o:a:_?c:l),E=S*(p?_?c:l:_?o:a);return`M${b},${C+hf(R,E)}A${R},${R} 0 0 ${R<0?0:1} ${b+ff(R,E)},${C}H${x-ff(M,v)}A${M},${M} 0 0 ${M<0?0:1} ${x},${C+hf(M,v)}V${w-hf(v,M)}A${v},${v} 0 0 ${v<0?0:1} ${x-ff(v,M)},${w}H${b+ff(E,R)}A${E},${E} 0 0 ${E<0?0:1} ${b},${w-hf(E,R)}Z`})}function ff(e,t){return t<0?e:Math.abs(e)}function hf(e,t){return t<0?Math.abs(e):e}function m0(e,t){return new df(e,kS(zS(t)))}var eD={ariaLabel:"frame",fill:"none",stroke:"currentColor",clip:!1},nD={ariaLabel:"frame",fill:null,stroke:"currentColor",strokeLinecap:"square",clip:!1},g0=class extends de{constructor(t={}){let{anchor:n=null}=t;super(Go,void 0,t,n==null?eD:nD),this.anchor=ug(n,"anchor",["top","right","bottom","left"]),Xc(this,t),n||Yc(this,t)}render(t,n,i,r,s){let{marginTop:o,marginRight:a,marginBottom:c,marginLeft:l,width:u,height:h}=r,{anchor:f,insetTop:d,insetRight:m,insetBottom:y,insetLeft:g}=this,{rx:p,ry:_,rx1y1:b,rx1y2:x,rx2y1:C,rx2y2:w}=this,S=l+g,R=u-a-m,M=o+d,v=h-c-y;return te(f?"svg:line":b||x||C||w?"svg:path":"svg:rect",s).datum(0).call(Le,this,r,s).call(Me,this).call(je,this,i).call(we,this,{}).call(f==="left"?E=>E.attr("x1",S).attr("x2",S).attr("y1",M).attr("y2",v):f==="right"?E=>E.attr("x1",R).attr("x2",R).attr("y1",M).attr("y2",v):f==="top"?E=>E.attr("x1",S).attr("x2",R).attr("y1",M).attr("y2",M):f==="bottom"?E=>E.attr("x1",S).attr("x2",R).attr("y1",v).attr("y2",v):b||x||C||w?E=>E.call(qc,S,M,R,v,this):E=>E.attr("x",S).attr("y",M).attr("width",R-S).attr("height",v-M).attr("rx",p).attr("ry",_)).node()}};function B2(e){return new g0(e)}var y0={ariaLabel:"tip",fill:"var(--plot-background)",stroke:"currentColor"},iD=new Set(["geometry","href","src","ariaLabel","scales"]),pf=class extends de{constructor(t,n={}){n.tip&&(n={...n,tip:!1}),n.title===void 0&&xn(t)&&Nu(t)&&(n={...n,title:fe});let{x:i,y:r,x1:s,x2:o,y1:a,y2:c,anchor:l,preferredAnchor:u="bottom",monospace:h,fontFamily:f=h?"ui-monospace, monospace":void 0,fontSize:d,fontStyle:m,fontVariant:y,fontWeight:g,lineHeight:p=1,lineWidth:_=20,frameAnchor:b,format:x,textAnchor:C="start",textOverflow:w,textPadding:S=8,title:R,pointerSize:M=12,pathFilter:v="drop-shadow(0 3px 4px rgba(0,0,0,0.2))"}=n;super(t,{x:{value:s!=null&&o!=null?null:i,scale:"x",optional:!0},y:{value:a!=null&&c!=null?null:r,scale:"y",optional:!0},x1:{value:s,scale:"x",optional:o==null},y1:{value:a,scale:"y",optional:c==null},x2:{value:o,scale:"x",optional:s==null},y2:{value:c,scale:"y",optional:a==null},title:{value:R,optional:!0}},n,y0),this.anchor=Uu(l,"anchor"),this.preferredAnchor=Uu(u,"preferredAnchor"),this.frameAnchor=$r(b),this.textAnchor=Ce(C,"middle"),this.textPadding=+S,this.pointerSize=+M,this.pathFilter=Ie(v),this.lineHeight=+p,this.lineWidth=+_,this.textOverflow=s0(w),this.monospace=!!h,this.fontFamily=Ie(f),this.fontSize=Pe(d),this.fontStyle=Ie(m),this.fontVariant=Ie(y),this.fontWeight=Ie(g);for(let E in y0)E in this.channels&&(this[E]=y0[E]);this.splitLines=l0(this),this.clipLine=u0(this),this.format=typeof x=="string"||typeof x=="function"?{title:x}:{...x}}render(t,n,i,r,s){let o=this,{x:a,y:c,fx:l,fy:u}=n,{ownerSVGElement:h,document:f}=s,{anchor:d,monospace:m,lineHeight:y,lineWidth:g}=this,{textPadding:p,pointerSize:_,pathFilter:b}=this,{marginTop:x,marginLeft:C}=r,{x1:w,y1:S,x2:R,y2:M,x:v=w??R,y:E=S??M}=i,N=l?l(t.fx)-C:0,U=u?u(t.fy)-x:0,[F,P]=Hi(this,r),O=Jg(i,F),H=Kg(i,P),z=m?sf:rf,G=z(Xs),j,nt;"title"in i?(j=k2.call(this,{title:i.channels.title},n),nt=aD):(j=k2.call(this,i.channels,n),nt=cD);let ct=te("svg:g",s).call(Le,this,r,s).call(c0,this).call(we,this,{x:v&&a,y:E&&c}).call(tt=>tt.selectAll().data(t).enter().append("g").attr("transform",lt=>`translate(${Math.round(O(lt))},${Math.round(H(lt))})`).call(Me,this).call(lt=>lt.append("path").attr("filter",b)).call(lt=>lt.append("text").each(function(K){let ut=si(this);this.setAttribute("fill","currentColor"),this.setAttribute("fill-opacity",1),this.setAttribute("stroke","none");let q=nt.call(o,K,t,j,n,i);if(typeof q=="string")for(let ot of o.splitLines(q))ft(ut,{value:o.clipLine(ot)});else{let ot=new Set;for(let pt of q){let{label:X=""}=pt;X&&ot.has(X)||(ot.add(X),ft(ut,pt))}}})));function ft(tt,{label:lt,value:K,color:ut,opacity:q}){lt??(lt=""),K??(K="");let ot=ut!=null||q!=null,pt,X=g*100,[Lt]=Ys(lt,X,z,G);if(Lt>=0)lt=lt.slice(0,Lt).trimEnd()+Xs,pt=K.trim(),K="";else{(lt||!K&&!ot)&&(K=" "+K);let[Ot]=Ys(K,X-z(lt),z,G);Ot>=0&&(pt=K.trim(),K=K.slice(0,Ot).trimEnd()+Xs)}let L=tt.append("tspan").attr("x",0).attr("dy",`${y}em`).text("​");lt&&L.append("tspan").attr("font-weight","bold").text(lt),K&&L.append(()=>f.createTextNode(K)),ot&&L.append("tspan").text(" ■").attr("fill",ut).attr("fill-opacity",q).style("user-select","none"),pt&&L.append("title").text(pt)}function $(){let{width:tt,height:lt}=r.facet??r;ct.selectChildren().each(function(K){let{x:ut,width:q,height:ot}=this.getBBox();q=Math.round(q),ot=Math.round(ot);let pt=d;if(pt===void 0){let L=O(K)+N,Ot=H(K)+U,St=L+q+_+p*2<tt,Ut=L-q-_-p*2>0,Tt=Ot+ot+_+p*2<lt,Qt=Ot-ot-_-p*2>0;pt=St&&Ut?Tt&&Qt?o.preferredAnchor:Qt?"bottom":"top":Tt&&Qt?St?"left":"right":(St||Ut)&&(Tt||Qt)?`${Qt?"bottom":"top"}-${St?"left":"right"}`:o.preferredAnchor}let X=this.firstChild,Lt=this.lastChild;if(X.setAttribute("d",oD(pt,_,p,q,ot)),ut)for(let L of Lt.childNodes)L.setAttribute("x",-ut);Lt.setAttribute("y",`${+rD(pt,Lt.childNodes.length,y).toFixed(6)}em`),Lt.setAttribute("transform",`translate(${sD(pt,_,p,q,ot)})`)}),ct.attr("visibility",null)}return t.length&&(ct.attr("visibility","hidden"),h.isConnected?Promise.resolve().then($):typeof requestAnimationFrame<"u"&&requestAnimationFrame($)),ct.node()}};function Zc(e,{x:t,y:n,...i}={}){return i.frameAnchor===void 0&&([t,n]=Zn(t,n)),new pf(e,{...i,x:t,y:n})}function rD(e,t,n){return/^top(?:-|$)/.test(e)?.94-n:-.29-t*n}function sD(e,t,n,i,r){switch(e){case"middle":return[-i/2,r/2];case"top-left":return[n,t+n];case"top":return[-i/2,t/2+n];case"top-right":return[-i-n,t+n];case"right":return[-t/2-i-n,r/2];case"bottom-left":return[n,-t-n];case"bottom":return[-i/2,-t/2-n];case"bottom-right":return[-i-n,-t-n];case"left":return[n+t/2,r/2]}}function oD(e,t,n,i,r){let s=i+n*2,o=r+n*2;switch(e){case"middle":return`M${-s/2},${-o/2}h${s}v${o}h${-s}z`;case"top-left":return`M0,0l${t},${t}h${s-t}v${o}h${-s}z`;case"top":return`M0,0l${t/2},${t/2}h${(s-t)/2}v${o}h${-s}v${-o}h${(s-t)/2}z`;case"top-right":return`M0,0l${-t},${t}h${t-s}v${o}h${s}z`;case"right":return`M0,0l${-t/2},${-t/2}v${t/2-o/2}h${-s}v${o}h${s}v${t/2-o/2}z`;case"bottom-left":return`M0,0l${t},${-t}h${s-t}v${-o}h${-s}z`;case"bottom":return`M0,0l${t/2},${-t/2}h${(s-t)/2}v${-o}h${-s}v${o}h${(s-t)/2}z`;case"bottom-right":return`M0,0l${-t},${-t}h${t-s}v${-o}h${s}z`;case"left":return`M0,0l${t/2},${-t/2}v${t/2-o/2}h${s}v${o}h${-s}v${t/2-o/2}z`}}function k2(e,t){let n={},i=this.format;i=z2(i,e,"x"),i=z2(i,e,"y"),this.format=i;for(let r in i){let s=i[r];if(!(s===null||s===!1))if(r==="fx"||r==="fy")n[r]=!0;else{let o=Ag(e,r);o&&(n[r]=o)}}for(let r in e){if(r in n||r in i||iD.has(r)||(r==="x"||r==="y")&&e.geometry)continue;let s=Ag(e,r);if(s){if(s.scale==null&&s.defaultScale==="color")continue;n[r]=s}}this.facet&&(t.fx&&!("fx"in i)&&(n.fx=!0),t.fy&&!("fy"in i)&&(n.fy=!0));for(let r in n){let s=this.format[r];if(typeof s=="string"){let o=n[r]?.value??t[r]?.domain()??[];this.format[r]=(Re(o)?Li:Ei)(s)}else if(s===void 0||s===!0){let o=t[r];this.format[r]=o?.bandwidth?$c(o,o.domain()):Vi}}return n}function z2(e,t,n){if(!(n in e))return e;let i=`${n}1`,r=`${n}2`;if((i in e||!(i in t))&&(r in e||!(r in t)))return e;let s=Object.entries(e),o=e[n];return s.splice(s.findIndex(([a])=>a===n)+1,0,[i,o],[r,o]),Object.fromEntries(s)}function aD(e,t,{title:n}){return this.format.title(n.value[e],e)}function*cD(e,t,n,i,r){for(let s in n){if(s==="fx"||s==="fy"){yield{label:mf(i,n,s),value:this.format[s](t[s],e)};continue}if(s==="x1"&&"x2"in n||s==="y1"&&"y2"in n)continue;let o=n[s];if(s==="x2"&&"x1"in n)yield{label:H2(i,n,"x"),value:V2(this.format.x2,n.x1,o,e)};else if(s==="y2"&&"y1"in n)yield{label:H2(i,n,"y"),value:V2(this.format.y2,n.y1,o,e)};else{let a=o.value[e],c=o.scale;if(!qn(a)&&c==null)continue;yield{label:mf(i,n,s),value:this.format[s](a,e),color:c==="color"?r[s][e]:null,opacity:c==="opacity"?r[s][e]:null}}}}function V2(e,t,n,i){return n.hint?.length?`${e(n.value[i]-t.value[i],i)}`:`${e(t.value[i],i)}–${e(n.value[i],i)}`}function H2(e,t,n){let i=mf(e,t,`${n}1`,n),r=mf(e,t,`${n}2`,n);return i===r?i:`${i}–${r}`}function mf(e,t,n,i=n){let r=t[n],s=e[r?.scale??n];return String(s?.label??r?.label??i)}function Kc(e={}){let{facet:t,style:n,title:i,subtitle:r,caption:s,ariaLabel:o,ariaDescription:a}=e,c=ra(e.className),l=e.marks===void 0?[]:W2(e.marks);l.push(...pD(l));let u=hD(t,e),h=new Map;for(let G of l){let j=$2(G,u,e);j&&h.set(G,j)}let f=new Map;u&&Jc(f,[u],e),Jc(f,h,e);let d=W2(mD(l,f,e));for(let G of d){let j=$2(G,u,e);j&&h.set(G,j)}l.unshift(...d);let m=uS(f,e);if(m!==void 0){let G=u?$u(m,u):void 0;for(let nt of l){if(nt.facet===null||nt.facet==="super")continue;let ct=h.get(nt);ct!==void 0&&(ct.facetsIndex=nt.fx!=null||nt.fy!=null?$u(m,ct):G)}let j=new Set;for(let{facetsIndex:nt}of h.values())nt?.forEach((ct,ft)=>{ct?.length>0&&j.add(ft)});m.forEach(0<j.size&&j.size<m.length?(nt,ct)=>nt.empty=!j.has(ct):nt=>nt.empty=!1);for(let nt of l)if(nt.facet==="exclude"){let ct=h.get(nt);ct!==void 0&&(ct.facetsIndex=dS(ct.facetsIndex))}}for(let G of he.keys())Wo(e[G])&&G!=="fx"&&G!=="fy"&&f.set(G,[]);let y=new Map;for(let G of l){if(y.has(G))throw new Error("duplicate mark; each mark must be unique");let{facetsIndex:j,channels:nt}=h.get(G)??{},{data:ct,facets:ft,channels:$}=G.initialize(j,nt,e);v0($,e),y.set(G,{data:ct,facets:ft,channels:$})}let g=kc(Jc(f,y,e),e),p=CS(g,l,e);rS(g,p);let _=Og(g),{fx:b,fy:x}=_,C=b||x?Bg(g,p):p,w=b||x?MD(_,p):p,S=ia(e),R=S.document,M=wo("svg").call(R.documentElement),v=M;S.ownerSVGElement=M,S.className=c,S.projection=gS(e,C),S.path=function(){return dc(this.projection??MS(_))},S.filterFacets=(G,j)=>$u(m,{channels:j,groups:Gu(G,j)}),S.getMarkState=G=>{let j=y.get(G),nt=h.get(G);return{...j,channels:{...j.channels,...nt?.channels}}},S.dispatchValue=G=>{v.value!==G&&(v.value=G,v.dispatchEvent(new S.document.defaultView.Event("input",{bubbles:!0})))};let E=new Set;for(let[G,j]of y)if(G.initializer!=null){let nt=G.facet==="super"?w:C,ct=G.initializer(j.data,j.facets,j.channels,_,nt,S);if(ct.data!==void 0&&(j.data=ct.data),ct.facets!==void 0&&(j.facets=ct.facets),ct.channels!==void 0){let{fx:ft,fy:$,...tt}=ct.channels;fD(tt),Object.assign(j.channels,tt);for(let lt of Object.values(tt)){let{scale:K}=lt;K!=null&&!nw(he.get(K))&&(q2(lt,e),E.add(K))}(ft!=null||$!=null)&&h.set(G,!0)}}if(E.size){let G=new Map;Jc(G,y,e,ft=>E.has(ft)),Jc(f,y,e,ft=>E.has(ft));let j=bD(kc(G,e),g),{scales:nt,...ct}=Og(j);Object.assign(g,j),Object.assign(_,ct),Object.assign(_.scales,nt)}let N,U;m!==void 0&&(N={x:b?.domain(),y:x?.domain()},m=fS(m,N),U=hS(b,x,p));for(let[G,j]of y)j.values=G.scale(j.channels,_,S);let{width:F,height:P}=p;si(M).attr("class",c).attr("fill","currentColor").attr("font-family","system-ui, sans-serif").attr("font-size",10).attr("text-anchor","middle").attr("width",F).attr("height",P).attr("viewBox",`0 0 ${F} ${P}`).attr("aria-label",o).attr("aria-description",a).call(G=>G.append("style").text(`:where(.${c}) {
  --plot-background: white;
  display: block;
  height: auto;
  height: intrinsic;
  max-width: 100%;
}
:where(.${c} text),
:where(.${c} tspan) {
  white-space: pre;
}`)).call(sa,n);for(let G of l){let{channels:j,values:nt,facets:ct}=y.get(G);if(m===void 0||G.facet==="super"){let ft=null;if(ct&&(ft=ct[0],ft=G.filter(ft,j,nt),ft.length===0))continue;let $=G.render(ft,_,nt,w,S);if($==null)continue;M.appendChild($)}else{let ft;for(let $ of m){if(!(G.facetAnchor?.(m,N,$)??!$.empty))continue;let tt=null;if(ct){let K=h.has(G);if(tt=ct[K?$.i:0],tt=G.filter(tt,j,nt),tt.length===0)continue;!K&&tt===ct[0]&&(tt=HM(tt)),tt.fx=$.x,tt.fy=$.y,tt.fi=$.i}let lt=G.render(tt,_,nt,C,S);if(lt!=null){(ft??(ft=si(M).append("g"))).append(()=>lt).datum($);for(let K of["aria-label","aria-description","aria-hidden","transform"])lt.hasAttribute(K)&&(ft.attr(K,lt.getAttribute(K)),lt.removeAttribute(K))}}ft?.selectChildren().each(U)}}let O=I2(g,S,e),{figure:H=i!=null||r!=null||s!=null||O.length>0}=e;H&&(v=R.createElement("figure"),v.className=`${c}-figure`,v.style.maxWidth="initial",i!=null&&v.append(G2(R,i,"h2")),r!=null&&v.append(G2(R,r,"h3")),v.append(...O,M),s!=null&&v.append(lD(R,s)),"value"in M&&(v.value=M.value,delete M.value)),v.scale=cS(_.scales),v.legend=A2(g,S,e);let z=kw();return z>0&&si(M).append("text").attr("x",F).attr("y",20).attr("dy","-1em").attr("text-anchor","end").attr("font-family","initial").text("⚠️").append("title").text(`${z.toLocaleString("en-US")} warning${z===1?"":"s"}. Please check the console.`),v}function G2(e,t,n){if(t.ownerDocument)return t;let i=e.createElement(n);return i.append(t),i}function lD(e,t){let n=e.createElement("figcaption");return n.append(t),n}function W2(e){return e.flat(1/0).filter(t=>t!=null).map(uD)}function uD(e){return typeof e.render=="function"?e:new _0(e)}var _0=class extends de{constructor(t){if(typeof t!="function")throw new TypeError("invalid mark; missing render function");super(),this.render=t}render(){}};function v0(e,t){for(let n in e)q2(e[n],t);return e}function q2(e,t){let{scale:n,transform:i=!0}=e;if(n==null||!i)return;let{type:r,percent:s,interval:o,transform:a=s?c=>c==null?NaN:c*100:dg(o,r)}=t[n]??{};a!=null&&(e.value=ue(e.value,a),e.transform=!1)}function fD(e){for(let t in e)Eg(t,e[t])}function Jc(e,t,n,i=OM){for(let{channels:r}of t.values())for(let s in r){let o=r[s],{scale:a}=o;if(a!=null&&i(a))if(a==="projection"){if(!_S(n)){let c=n.x?.domain===void 0,l=n.y?.domain===void 0;if(c||l){let[u,h]=bS(o);c&&x0(e,"x",u),l&&x0(e,"y",h)}}}else x0(e,a,o)}return e}function x0(e,t,n){let i=e.get(t);i!==void 0?i.push(n):e.set(t,[n])}function hD(e,t){if(e==null)return;let{x:n,y:i}=e;if(n==null&&i==null)return;let r=ar(e.data);if(r==null)throw new Error("missing facet data");let s={};n!=null&&(s.fx=Ko(r,{value:n,scale:"fx"})),i!=null&&(s.fy=Ko(r,{value:i,scale:"fy"})),v0(s,t);let o=Gu(r,s);return{channels:s,groups:o,data:e.data}}function $2(e,t,n){if(e.facet===null||e.facet==="super")return;let{fx:i,fy:r}=e;if(i!=null||r!=null){let c=ar(e.data??i??r);if(c===void 0)throw new Error(`missing facet data in ${e.ariaLabel}`);if(c===null)return;let l={};return i!=null&&(l.fx=Ko(c,{value:i,scale:"fx"})),r!=null&&(l.fy=Ko(c,{value:r,scale:"fy"})),v0(l,n),{channels:l,groups:Gu(c,l)}}if(t===void 0)return;let{channels:s,groups:o,data:a}=t;if(e.facet!=="auto"||e.data===a)return{channels:s,groups:o};a.length>0&&(o.size>1||o.size===1&&s.fx&&s.fy&&[...o][0][1].size>1)&&Gr(ar(e.data))===Gr(a)&&_n(`Warning: the ${e.ariaLabel} mark appears to use faceted data, but isn’t faceted. The mark data has the same length as the facet data and the mark facet option is "auto", but the mark data and facet data are distinct. If this mark should be faceted, set the mark facet option to true; otherwise, suppress this warning by setting the mark facet option to false.`)}function dD(e,t={}){return cr({...t,x:null,y:null},(n,i,r,s,o,a)=>a.getMarkState(e))}function pD(e){let t=[];for(let n of e){let i=n.tip;if(i){i===!0?i={}:typeof i=="string"&&(i={pointer:i});let{pointer:r,preferredAnchor:s}=i;r=/^x$/i.test(r)?Hc:/^y$/i.test(r)?Ku:Vc,i=r(dD(n,i)),i.title=null,s===void 0&&(i.preferredAnchor=r===Ku?"left":"bottom");let o=Zc(n.data,i);o.facet=n.facet,o.facetAnchor=n.facetAnchor,t.push(o)}}return t}function mD(e,t,n){let{projection:i,x:r={},y:s={},fx:o={},fy:a={},axis:c,grid:l,facet:u={},facet:{axis:h=c,grid:f}=u,x:{axis:d=c,grid:m=d===null?null:l}=r,y:{axis:y=c,grid:g=y===null?null:l}=s,fx:{axis:p=h,grid:_=p===null?null:f}=o,fy:{axis:b=h,grid:x=b===null?null:f}=a}=n;(i||!Wo(r)&&!X2("x",e))&&(d=m=null),(i||!Wo(s)&&!X2("y",e))&&(y=g=null),t.has("fx")||(p=_=null),t.has("fy")||(b=x=null),d===void 0&&(d=!xf(e,"x")),y===void 0&&(y=!xf(e,"y")),p===void 0&&(p=!xf(e,"fx")),b===void 0&&(b=!xf(e,"fy")),d===!0&&(d="bottom"),y===!0&&(y="left"),p===!0&&(p=d==="top"||d===null?"bottom":"top"),b===!0&&(b=y==="right"||y===null?"left":"right");let C=[];return yf(C,x,f2,a),gf(C,b,o2,"right","left",u,a),yf(C,_,d2,o),gf(C,p,a2,"top","bottom",u,o),yf(C,g,u2,s),gf(C,y,h0,"left","right",n,s),yf(C,m,h2,r),gf(C,d,d0,"bottom","top",n,r),C}function gf(e,t,n,i,r,s,o){if(!t)return;let a=gD(t);o=yD(a?i:t,s,o);let{line:c}=o;(n===h0||n===d0)&&c&&!ks(c)&&e.push(B2(xD(o))),e.push(n(o)),a&&e.push(n({...o,anchor:r,label:null}))}function yf(e,t,n,i){!t||ks(t)||e.push(n(_D(t,i)))}function gD(e){return/^\s*both\s*$/i.test(e)}function yD(e,t,{line:n=t.line,ticks:i,tickSize:r,tickSpacing:s,tickPadding:o,tickFormat:a,tickRotate:c,fontVariant:l,ariaLabel:u,ariaDescription:h,label:f=t.label,labelAnchor:d,labelArrow:m=t.labelArrow,labelOffset:y}){return{anchor:e,line:n,ticks:i,tickSize:r,tickSpacing:s,tickPadding:o,tickFormat:a,tickRotate:c,fontVariant:l,ariaLabel:u,ariaDescription:h,label:f,labelAnchor:d,labelArrow:m,labelOffset:y}}function xD(e){let{anchor:t,line:n}=e;return{anchor:t,facetAnchor:t+"-empty",stroke:n===!0?void 0:n}}function _D(e,{stroke:t=qo(e)?e:void 0,ticks:n=vD(e)?e:void 0,tickSpacing:i,ariaLabel:r,ariaDescription:s}){return{stroke:t,ticks:n,tickSpacing:i,ariaLabel:r,ariaDescription:s}}function vD(e){switch(typeof e){case"number":return!0;case"string":return!qo(e)}return xn(e)||typeof e?.range=="function"}function xf(e,t){let n=`${t}-axis `;return e.some(i=>i.ariaLabel?.startsWith(n))}function X2(e,t){for(let n of t)for(let i in n.channels){let{scale:r}=n.channels[i];if(r===e||r==="projection")return!0}return!1}function bD(e,t){for(let n in e){let i=e[n],r=t[n];i.label===void 0&&r&&(i.label=r.label)}return e}function MD({fx:e,fy:t},n){let{marginTop:i,marginRight:r,marginBottom:s,marginLeft:o,width:a,height:c}=Vu(n),l=e&&Y2(e),u=t&&Y2(t);return{marginTop:t?u[0]:i,marginRight:e?a-l[1]:r,marginBottom:t?c-u[1]:s,marginLeft:e?l[0]:o,inset:{marginTop:n.marginTop,marginRight:n.marginRight,marginBottom:n.marginBottom,marginLeft:n.marginLeft},width:a,height:c}}function Y2(e){let t=e.domain();if(t.length===0)return[0,e.bandwidth()];let n=e(t[0]),i=e(t[t.length-1]);return i<n&&([n,i]=[i,n]),[n,i+e.bandwidth()]}var wD=new Map([["basis",tM],["basis-closed",nM],["basis-open",rM],["bundle",oM],["bump-x",q1],["bump-y",Z1],["cardinal",aM],["cardinal-closed",cM],["cardinal-open",lM],["catmull-rom",fM],["catmull-rom-closed",dM],["catmull-rom-open",mM],["linear",Ds],["linear-closed",yM],["monotone-x",vM],["monotone-y",bM],["natural",wM],["step",SM],["step-after",EM],["step-before",TM]]);function b0(e=Ds,t){if(typeof e=="function")return e;let n=wD.get(`${e}`.toLowerCase());if(!n)throw new Error(`unknown curve: ${e}`);if(t!==void 0){if("beta"in n)return n.beta(t);if("tension"in n)return n.tension(t);if("alpha"in n)return n.alpha(t)}return n}function Z2(e=jc,t){return typeof e!="function"&&`${e}`.toLowerCase()==="auto"?jc:b0(e,t)}function jc(e){return Ds(e)}function SD(e={y:"count"},t={}){[e,t]=AD(e,t);let{x:n,y:i}=t;return ED(CD(n,t,fe),null,null,i,e,oa(t))}function TD(e,t,n={}){if(n?.interval==null)return n;let{reduce:i=Ou}=n,r={filter:null};return n[t]!=null&&(r[t]=i),n[`${t}1`]!=null&&(r[`${t}1`]=i),n[`${t}2`]!=null&&(r[`${t}2`]=i),e(r,n)}function _f(e={}){return TD(SD,"y",Ws(e,"x"))}function ED(e,t,n,i,{data:r=Sg,filter:s=Dc,sort:o,reverse:a,...c}={},l={}){e=J2(e),t=J2(t),c=ID(c,l),r=tT(r,fe),o=o==null?void 0:j2("sort",o,l),s=s==null?void 0:Q2("filter",s,l),n!=null&&Uc(c,"x","x1","x2")&&(n=null),i!=null&&Uc(c,"y","y1","y2")&&(i=null);let[u,h]=Kn(e),[f,d]=Kn(e),[m,y]=Kn(t),[g,p]=Kn(t),[_,b]=n!=null?[n,"x"]:i!=null?[i,"y"]:[],[x,C]=Kn(_),{x:w,y:S,z:R,fill:M,stroke:v,x1:E,x2:N,y1:U,y2:F,domain:P,cumulative:O,thresholds:H,interval:z,...G}=l,[j,nt]=Kn(R),[ct]=ln(M),[ft]=ln(v),[$,tt]=Kn(ct),[lt,K]=Kn(ft);return{..."z"in l&&{z:j||R},..."fill"in l&&{fill:$||M},..."stroke"in l&&{stroke:lt||v},...Gs(G,(ut,q,ot)=>{let pt=Nc(ve(ut,_),ot?.[b]),X=ve(ut,R),Lt=ve(ut,ct),L=ve(ut,ft),Ot=hw(c,{z:X,fill:Lt,stroke:L}),St=[],Ut=[],Tt=pt&&C([]),Qt=X&&nt([]),Dt=Lt&&tt([]),I=L&&K([]),T=e&&h([]),W=e&&d([]),rt=t&&y([]),at=t&&p([]),et=ND(e,t,ut),Et=0;for(let mt of c)mt.initialize(ut);o&&o.initialize(ut),s&&s.initialize(ut);for(let mt of q){let Mt=[];for(let $t of c)$t.scope("facet",mt);o&&o.scope("facet",mt),s&&s.scope("facet",mt);for(let[$t,ht]of wg(mt,Ot))for(let[wt,Nt]of wg(ht,pt))for(let[It,yt]of et(Nt))if(Ot&&(yt.z=$t),!(s&&!s.reduce(It,yt))){Mt.push(Et++),Ut.push(r.reduceIndex(It,ut,yt)),pt&&Tt.push(wt),X&&Qt.push(Ot===X?$t:X[(It.length>0?It:Nt)[0]]),Lt&&Dt.push(Ot===Lt?$t:Lt[(It.length>0?It:Nt)[0]]),L&&I.push(Ot===L?$t:L[(It.length>0?It:Nt)[0]]),T&&(T.push(yt.x1),W.push(yt.x2)),rt&&(rt.push(yt.y1),at.push(yt.y2));for(let Jt of c)Jt.reduce(It,yt);o&&o.reduce(It,yt)}St.push(Mt)}return dw(St,o,a),{data:Ut,facets:St}}),...!Uc(c,"x")&&(u?{x1:u,x2:f,x:Lc(u,f)}:{x:w,x1:E,x2:N}),...!Uc(c,"y")&&(m?{y1:m,y2:g,y:Lc(m,g)}:{y:S,y1:U,y2:F}),...x&&{[b]:x},...Object.fromEntries(c.map(({name:ut,output:q})=>[ut,q]))}}function AD({cumulative:e,domain:t,thresholds:n,interval:i,...r},s){return[r,{cumulative:e,domain:t,thresholds:n,interval:i,...s}]}function CD(e,{cumulative:t,domain:n,thresholds:i,interval:r},s){return e={...ki(e)},e.domain===void 0&&(e.domain=n),e.cumulative===void 0&&(e.cumulative=t),e.thresholds===void 0&&(e.thresholds=i),e.interval===void 0&&(e.interval=r),e.value===void 0&&(e.value=s),e.thresholds=RD(e.thresholds,e.interval),e}function J2(e){if(e==null)return;let{value:t,cumulative:n,domain:i=Je,thresholds:r}=e,s=o=>{let a=ve(o,t),c;if(Re(a)||LD(r)){a=ue(a,lg,Float64Array);let[u,h]=typeof i=="function"?i(a):i,f=typeof r=="function"&&!Wr(r)?r(a,u,h):r;typeof f=="number"&&(f=au(u,h,f)),Wr(f)&&(i===Je&&(u=f.floor(u),h=f.offset(f.floor(h))),f=f.range(u,f.offset(h))),c=f}else{a=Fi(a);let[u,h]=typeof i=="function"?i(a):i,f=typeof r=="function"&&!Wr(r)?r(a,u,h):r;if(typeof f=="number")if(i===Je){let d=xo(u,h,f);if(isFinite(d))if(d>0){let m=Math.round(u/d),y=Math.round(h/d);m*d<=u||--m,y*d>h||++y;let g=y-m+1;f=new Float64Array(g);for(let p=0;p<g;++p)f[p]=(m+p)*d}else if(d<0){d=-d;let m=Math.round(u*d),y=Math.round(h*d);m/d<=u||--m,y/d>h||++y;let g=y-m+1;f=new Float64Array(g);for(let p=0;p<g;++p)f[p]=(m+p)/d}else f=[u];else f=[u]}else f=Pr(u,h,f);else Wr(f)&&(i===Je&&(u=f.floor(u),h=f.offset(f.floor(h))),f=f.range(u,f.offset(h)));c=f}let l=[];if(c.length===1)l.push([c[0],c[0]]);else for(let u=1;u<c.length;++u)l.push([c[u-1],c[u]]);return l.bin=(n<0?UD:n>0?DD:M0)(l,c,a),l};return s.label=fi(t),s}function RD(e,t,n=K2){if(e===void 0)return t===void 0?n:Bi(t);if(typeof e=="string"){switch(e.toLowerCase()){case"freedman-diaconis":return S_;case"scott":return td;case"sturges":return __;case"auto":return K2}return Ic(e)}return e}function ID(e,t){return fw(e,t,j2)}function j2(e,t,n){return bg(e,t,n,Q2)}function Q2(e,t,n){return Mg(e,t,n,tT)}function tT(e,t){return Fc(e,t,PD)}function PD(e){switch(`${e}`.toLowerCase()){case"x":return FD;case"x1":return BD;case"x2":return kD;case"y":return OD;case"y1":return zD;case"y2":return VD;case"z":return pw}throw new Error(`invalid bin reduce: ${e}`)}function K2(e,t,n){return Math.min(200,td(e,t,n))}function LD(e){return $M(e)||xn(e)&&Re(e)}function ND(e,t,n){let i=e?.(n),r=t?.(n);return i&&r?function*(s){let o=i.bin(s);for(let[a,[c,l]]of i.entries()){let u=r.bin(o[a]);for(let[h,[f,d]]of r.entries())yield[u[h],{data:n,x1:c,y1:f,x2:l,y2:d}]}}:i?function*(s){let o=i.bin(s);for(let[a,[c,l]]of i.entries())yield[o[a],{data:n,x1:c,x2:l}]}:function*(s){let o=r.bin(s);for(let[a,[c,l]]of r.entries())yield[o[a],{data:n,y1:c,y2:l}]}}function M0(e,t,n){return t=Fi(t),i=>{let r=e.map(()=>[]);for(let s of i)r[vo(t,n[s])-1]?.push(s);return r}}function DD(e,t,n){let i=M0(e,t,n);return r=>{let s=i(r);for(let o=1,a=s.length;o<a;++o){let c=s[o-1],l=s[o];for(let u of c)l.push(u)}return s}}function UD(e,t,n){let i=M0(e,t,n);return r=>{let s=i(r);for(let o=s.length-2;o>=0;--o){let a=s[o+1],c=s[o];for(let l of a)c.push(l)}return s}}function eT(e,t){let n=(+e+ +t)/2;return e instanceof Date?new Date(n):n}var FD={reduceIndex(e,t,{x1:n,x2:i}){return eT(n,i)}},OD={reduceIndex(e,t,{y1:n,y2:i}){return eT(n,i)}},BD={reduceIndex(e,t,{x1:n}){return n}},kD={reduceIndex(e,t,{x2:n}){return n}},zD={reduceIndex(e,t,{y1:n}){return n}},VD={reduceIndex(e,t,{y2:n}){return n}};var $D={ariaLabel:"area",strokeWidth:1,strokeLinecap:"round",strokeLinejoin:"round",strokeMiterlimit:1},vf=class extends de{constructor(t,n={}){let{x1:i,y1:r,x2:s,y2:o,z:a,curve:c,tension:l}=n;super(t,{x1:{value:i,scale:"x"},y1:{value:r,scale:"y"},x2:{value:s,scale:"x",optional:!0},y2:{value:o,scale:"y",optional:!0},z:{value:Xo(n),optional:!0}},n,$D),this.z=a,this.curve=b0(c,l)}filter(t){return t}render(t,n,i,r,s){let{x1:o,y1:a,x2:c=o,y2:l=a}=i;return te("svg:g",s).call(Le,this,r,s).call(we,this,n,0,0).call(u=>u.selectAll().data(Ju(t,[o,a,c,l],this,i)).enter().append("path").call(Me,this).call(Zu,this,i).attr("d",X1().curve(this.curve).defined(h=>h>=0).x0(h=>o[h]).y0(h=>a[h]).x1(h=>c[h]).y1(h=>l[h]))).node()}};function bf(e,t){let{x:n=li,...i}=_f(t);return new vf(e,lf(cf({...i,x1:n,x2:void 0},n===li?"y2":"y")))}var XD={ariaLabel:"bar"},Qc=class extends de{constructor(t,n,i={},r=XD){super(t,n,i,r),Xc(this,i),Yc(this,i)}render(t,n,i,r,s){let{rx:o,ry:a,rx1y1:c,rx1y2:l,rx2y1:u,rx2y2:h}=this,f=this._x(n,i,r),d=this._y(n,i,r),m=this._width(n,i,r),y=this._height(n,i,r);return te("svg:g",s).call(Le,this,r,s).call(this._transform,this,n).call(g=>g.selectAll().data(t).enter().call(c||l||u||h?p=>p.append("path").call(Me,this).call(qc,f,d,nT(f,m),nT(d,y),this).call(je,this,i):p=>p.append("rect").call(Me,this).attr("x",f).attr("width",m).attr("y",d).attr("height",y).call(Ft,"rx",o).call(Ft,"ry",a).call(je,this,i))).node()}_x(t,{x:n},{marginLeft:i}){let{insetLeft:r}=this;return n?s=>n[s]+r:i+r}_y(t,{y:n},{marginTop:i}){let{insetTop:r}=this;return n?s=>n[s]+r:i+r}_width({x:t},{x:n},{marginRight:i,marginLeft:r,width:s}){let{insetLeft:o,insetRight:a}=this,c=n&&t?t.bandwidth():s-i-r;return Math.max(0,c-o-a)}_height({y:t},{y:n},{marginTop:i,marginBottom:r,height:s}){let{insetTop:o,insetBottom:a}=this,c=n&&t?t.bandwidth():s-i-r;return Math.max(0,c-o-a)}};function nT(e,t){return typeof e=="function"&&typeof t=="function"?n=>e(n)+t(n):typeof e=="function"?n=>e(n)+t:typeof t=="function"?n=>e+t(n):e+t}var Mf=class extends Qc{constructor(t,n={},i){let{x:r,y1:s,y2:o}=n;super(t,{y1:{value:s,scale:"y"},y2:{value:o,scale:"y"},x:{value:r,scale:"x",type:"band",optional:!0}},n,i)}_transform(t,n,{y:i}){t.call(we,n,{y:i},0,0)}_y({y:t},{y1:n,y2:i},{marginTop:r}){let{insetTop:s}=this;return hi(t)?r+s:o=>Math.min(n[o],i[o])+s}_height({y:t},{y1:n,y2:i},{marginTop:r,marginBottom:s,height:o}){let{insetTop:a,insetBottom:c}=this;return hi(t)?o-r-s-a-c:l=>Math.max(0,Math.abs(i[l]-n[l])-a-c)}};function w0(e,t={}){return hg(t)||(t={...t,x:li,y2:fe}),new Mf(e,lf(tf(cf(t))))}var YD={ariaLabel:"cell"},wf=class extends Qc{constructor(t,{x:n,y:i,...r}={}){super(t,{x:{value:n,scale:"x",type:"band",optional:!0},y:{value:i,scale:"y",type:"band",optional:!0}},r,YD)}_transform(t,n){t.call(we,n,{},0,0)}};function S0(e,{x:t,y:n,...i}={}){return[t,n]=Zn(t,n),new wf(e,{...i,x:t,y:n})}var qD={ariaLabel:"dot",fill:"none",stroke:"currentColor",strokeWidth:1.5};function ZD(e){return e.sort===void 0&&e.reverse===void 0?cw({channel:"-r"},e):e}var Sf=class extends de{constructor(t,n={}){let{x:i,y:r,r:s,rotate:o,symbol:a=Us,frameAnchor:c}=n,[l,u]=Ae(o,0),[h,f]=sw(a),[d,m]=Ae(s,h==null?3:4.5);super(t,{x:{value:i,scale:"x",optional:!0},y:{value:r,scale:"y",optional:!0},r:{value:d,scale:"r",filter:Os,optional:!0},rotate:{value:l,optional:!0},symbol:{value:h,scale:"auto",optional:!0}},ZD(n),qD),this.r=m,this.rotate=u,this.symbol=f,this.frameAnchor=$r(c);let{channels:y}=this,{symbol:g}=y;if(g){let{fill:p,stroke:_}=y;g.hint={fill:p?p.value===g.value?"color":"currentColor":this.fill??"currentColor",stroke:_?_.value===g.value?"color":"currentColor":this.stroke??"none"}}}render(t,n,i,r,s){let{x:o,y:a}=n,{x:c,y:l,r:u,rotate:h,symbol:f}=i,{r:d,rotate:m,symbol:y}=this,[g,p]=Hi(this,r),_=y===Us,b=u?void 0:d*d*Math.PI;return ko(d)&&(t=[]),te("svg:g",s).call(Le,this,r,s).call(we,this,{x:c&&o,y:l&&a}).call(x=>x.selectAll().data(t).enter().append(_?"circle":"path").call(Me,this).call(_?C=>{C.attr("cx",c?w=>c[w]:g).attr("cy",l?w=>l[w]:p).attr("r",u?w=>u[w]:d)}:C=>{C.attr("transform",aa`translate(${c?w=>c[w]:g},${l?w=>l[w]:p})${h?w=>` rotate(${h[w]})`:m?` rotate(${m})`:""}`).attr("d",u&&f?w=>{let S=Ti();return f[w].draw(S,u[w]*u[w]*Math.PI),S}:u?w=>{let S=Ti();return y.draw(S,u[w]*u[w]*Math.PI),S}:f?w=>{let S=Ti();return f[w].draw(S,b),S}:(()=>{let w=Ti();return y.draw(w,b),w})())}).call(je,this,i)).node()}};function fa(e,{x:t,y:n,...i}={}){return i.frameAnchor===void 0&&([t,n]=Zn(t,n)),new Sf(e,{...i,x:t,y:n})}var JD={ariaLabel:"line",fill:"none",stroke:"currentColor",strokeWidth:1.5,strokeLinecap:"round",strokeLinejoin:"round",strokeMiterlimit:1},Tf=class extends de{constructor(t,n={}){let{x:i,y:r,z:s,curve:o,tension:a}=n;super(t,{x:{value:i,scale:"x"},y:{value:r,scale:"y"},z:{value:Xo(n),optional:!0}},n,JD),this.z=s,this.curve=Z2(o,a),Gc(this,n)}filter(t){return t}project(t,n,i){this.curve!==jc&&super.project(t,n,i)}render(t,n,i,r,s){let{x:o,y:a}=i,{curve:c}=this;return te("svg:g",s).call(Le,this,r,s).call(we,this,n).call(l=>l.selectAll().data(Ju(t,[o,a],this,i)).enter().append("path").call(Me,this).call(Zu,this,i).call(NS,this,i,s).attr("d",c===jc&&s.projection?KD(s.path(),o,a):Nm().curve(c).defined(u=>u>=0).x(u=>o[u]).y(u=>a[u]))).node()}};function KD(e,t,n){return t=Fi(t),n=Fi(n),i=>{let r=[],s=[r];for(let o of i)o===-1?(r=[],s.push(r)):r.push([t[o],n[o]]);return e({type:"MultiLineString",coordinates:s})}}function Ef(e,{x:t=li,y:n=fe,...i}={}){return new Tf(e,_f({...i,x:t,y:n}))}de.prototype.plot=function({marks:e=[],...t}={}){return Kc({...t,marks:[...e,this]})};function tl(e){return`var(--role-${(e%8+8)%8})`}function el(e){return getComputedStyle(document.documentElement).getPropertyValue(`--role-${e%8}`).trim()}var Af=["440154","482475","414487","355f8d","2a788e","21918c","22a884","44bf70","7ad151","bddf26","fde725"].map(e=>[0,2,4].map(t=>parseInt(e.slice(t,t+2),16)));function Zr(e){let t=Math.min(Math.max(e,0),1)*(Af.length-1),n=Math.min(Math.floor(t),Af.length-2);return Af[n].map((i,r)=>Math.round(i+(t-n)*(Af[n+1][r]-i)))}function Jr([e,t,n]){return`rgb(${e}, ${t}, ${n})`}function rT([e,t,n]){return .299*e+.587*t+.114*n>140?"#000":"#fff"}function ha(e,t){let n=e.columns.findIndex(i=>i.name===t);return n<0?[]:e.values[n]??[]}function sT(e,t){return t!==void 0&&e.columns.some(n=>n.name===t)}function Cf(e){return e.values[0]?.length??0}function Rf(e){let t=i=>{if(i==null)return"";if(typeof i!="string")return String(i);let r=/^[=+\-@\t\r]/.test(i)?`'${i}`:i;return/[",\r\n]/.test(r)?`"${r.replaceAll('"','""')}"`:r},n=[e.columns.map(i=>t(i.name)).join(",")];for(let i=0;i<Cf(e);++i)n.push(e.values.map(r=>t(r[i])).join(","));return`${n.join(`\r
`)}\r
`}var jD=(e,t)=>e!=null&&(t!=="log"||e>0);function T0(e,t,n){let i=n.get(e.table);if(!i)return[];let r=p=>sT(i,p)?ha(i,p):null,[s,o,a,c,l]=[e.x,e.y,e.error,e.low,e.high].map(r),[u,h,f,d]=[e.fill,e.flag,e.group,e.tip].map(r),m=(p,_,b)=>p&&jD(p[_],b)?p[_]:NaN,{scale:y}=t.x??{},{scale:g}=t.y??{};return Array.from({length:i.values[0]?.length??0},(p,_)=>{let b=m(o,_,g),x=a&&a[_]!==null?a[_]:NaN;return{x:m(s,_,y),y:b,low:c?m(c,_,g):QD(b,x,g),high:l?m(l,_,g):b+x,error:x,fill:m(u,_),flag:!!h?.[_],group:f?String(f[_]):null,tip:d?String(d[_]??""):null}})}function QD(e,t,n){return n==="log"&&e-t<=0?e/10:e-t}function If(e){let t=[...new Set(e.filter(n=>typeof n=="string"||Number.isFinite(n)))];return t.every(n=>typeof n=="number")?t.sort((n,i)=>n-i):t}var Kr=(e,...t)=>e.filter(n=>t.every(i=>typeof n[i]=="string"||Number.isFinite(n[i])));function tU(e,t,n){return e.group?n.map((i,r)=>({rows:t.filter(s=>s.group===i),colour:tl(r),label:i})).filter(i=>i.rows.length>0):[{rows:t,colour:tl(e.colour??0),label:e.label}]}function oT(e,t){return If((e.marks??[]).filter(n=>n.group).flatMap(n=>T0(n,e,t).map(i=>i.group)))}function eU({rows:e,colour:t,label:n},i){let r=Kr(e,"x","low","high"),s=i.dash?"6 4":null;return[r.length>0?bf(r,{x:"x",y1:"low",y2:"high",fill:t,fillOpacity:.2,ariaHidden:"true"}):null,Ef(e,{x:"x",y:"y",stroke:t,strokeWidth:e.length>1e3?1:1.6,strokeDasharray:s,strokeLinejoin:"round",ariaDescription:n})]}function nU({rows:e,colour:t,label:n},i){let r=Kr(e,"x","y"),s=r.filter(c=>!c.flag),o=r.filter(c=>c.flag),a=r.length>150;return[Yr(Kr(r,"low","high"),{x:"x",y1:"low",y2:"high",stroke:t,strokeWidth:1.4,ariaHidden:"true"}),fa(s,{x:"x",y:"y",r:a?2:3.5,fill:i.open?"var(--card)":t,stroke:t,strokeWidth:i.open?1.6:.5,ariaDescription:n}),fa(o,{x:"x",y:"y",r:5,symbol:"triangle",fill:"var(--card)",stroke:"var(--bad)",strokeWidth:1.8,ariaDescription:`${n??""} (suspect)`})]}function iU({rows:e,colour:t,label:n}){return[bf(Kr(e,"x","low","high"),{x:"x",y1:"low",y2:"high",fill:t,fillOpacity:.22,ariaDescription:n})]}function rU({rows:e,colour:t,label:n}){return[Ef(e,{x:"x",y:"y",stroke:t,strokeWidth:1.6,curve:"step-after",ariaDescription:n})]}function sU({rows:e,colour:t,label:n}){let i=Kr(e,"x","y");return[w0(i,{x:"x",y:"y",fill:t,insetLeft:3,insetRight:3,ariaDescription:n}),Yr(Kr(i,"low","high"),{x:"x",y1:"low",y2:"high",stroke:"var(--ink)",strokeWidth:1.4,ariaHidden:"true"}),$s([0],{stroke:"var(--faint-ink)"})]}function oU(e,t){let n=tl(e.colour??7),i={stroke:n,strokeDasharray:"5 4",strokeWidth:1.2,ariaDescription:e.label},r={text:()=>e.label??"",fill:n,stroke:"var(--card)",strokeWidth:4,fontSize:11,ariaHidden:"true"};return e.type==="rule-x"?[Yr([e.value],i),dr([e.value],{...r,x:s=>s,frameAnchor:"top",textAnchor:"start",dx:4,dy:1+13*(t%2),lineAnchor:"top"})]:[$s([e.value],i),dr([e.value],{...r,y:s=>s,frameAnchor:"right",textAnchor:"end",dx:-2,dy:-7})]}function aU(e){let t=e.map(n=>n.fill).filter(Number.isFinite);return[Math.min(...t),Math.max(...t)]}function cU(e,t){let[n,i]=aU(e),r=a=>Zr(i>n?(a.fill-n)/(i-n):.5),s=Kr(e,"fill"),o=e.filter(a=>!Number.isFinite(a.fill));return[S0(s,{x:"x",y:"y",fill:a=>Jr(r(a)),inset:.5,ariaDescription:t}),dr(o,{x:"x",y:"y",text:()=>"✕",fill:"var(--bad)",ariaDescription:"failed"}),s.length<=150?dr(s,{x:"x",y:"y",text:a=>ce(a.fill,3),fill:a=>rT(r(a)),ariaHidden:"true"}):null]}function E0(e){let t=Math.abs(e.x);return t>3?"var(--bad)":t>2?"var(--doubt)":tl(0)}function lU(e,t){let n=Kr(e,"x","y"),i=[3,2,1].map(r=>({x1:-r,x2:r}));return[m0(i,{x1:"x1",x2:"x2",fill:"var(--faint-ink)",fillOpacity:.08,ariaHidden:"true"}),Yr([0],{stroke:"var(--faint-ink)"}),$s(n,{y:"y",x1:0,x2:"x",stroke:E0,strokeWidth:1.2,ariaHidden:"true"}),fa(n.filter(r=>!r.flag),{x:"x",y:"y",r:4,fill:E0,ariaDescription:t}),fa(n.filter(r=>r.flag),{x:"x",y:"y",r:5.5,symbol:"triangle",fill:"var(--card)",stroke:E0,strokeWidth:1.8,ariaDescription:`${t??""} (suspect)`})]}var uU={line:eU,dots:nU,band:iU,steps:rU,bars:sU},fU={dots:"dot",band:"band",bars:"band"};function hU(e){return e.open?"open":fU[e.type]??(e.dash?"dash":"line")}function aT(e,t,n,i,r){if(e.type==="rule-x"||e.type==="rule-y")return{marks:Number.isFinite(e.value)?oU(e,r):[],rows:[],key:[]};let s=T0(e,t,n);if(e.type==="cells")return{marks:cU(s,e.label),rows:s,key:[]};if(e.type==="diverging-dots"){let u=s.some(h=>h.flag)?[{label:"suspect",colour:"var(--faint-ink)",shape:"triangle"}]:[];return{marks:lU(s,e.label),rows:s,key:u}}let o=uU[e.type];if(!o)return{marks:[],rows:[],key:[]};let a=tU(e,s,i),c=hU(e),l=a.filter(u=>u.label).map(u=>({label:u.label,colour:u.colour,shape:c}));return s.some(u=>u.flag)&&l.push({label:"suspect",colour:"var(--bad)",shape:"triangle"}),{marks:a.flatMap(u=>o(u,e)),rows:e.type==="band"?[]:s.map(u=>({...u,label:u.group??e.label})),key:l}}var dU="http://www.w3.org/2000/svg";function pU(e,t){if(e.tip)return e.tip;let n=typeof e.x=="string"?e.x:`${jt(t.x?.label)} = ${ce(e.x)}`,i=typeof e.y=="string"?e.y:`${jt(t.y?.label)} = ${Ir(e.y,e.error)}`;return[e.label,n,i].filter(Boolean).join(`
`).replace(/_(\w)/g,"$1")}function mU(e){let t=e.filter(o=>o>0).map(Math.log10),[n,i]=[Math.ceil(Math.min(...t)-1e-9),Math.floor(Math.max(...t)+1e-9)],r=Math.max(1,Math.ceil((i-n)/8)),s=[];for(let o=n;o<=i;o+=r)s.push(10**o);return s.length>1?s:void 0}function cT(e,t,n){let i={label:jt(e?.label),grid:!n,nice:!1};if(n)return{...i,domain:If(t)};let r=Math.max(0,...t.filter(Number.isFinite).map(Math.abs));return e?.scale==="log"&&Object.assign(i,{type:"log",ticks:mU(t)}),(e?.scale==="log"||r<.001||r>=1e6)&&(i.tickFormat=s=>ce(s,5)),i}function gU(e){for(let t of e.querySelectorAll('g[aria-label$="axis label"] text')){if(!t.textContent.includes("_"))continue;let n=Xh(t.textContent);t.replaceChildren();let i=!1;for(let[r,s]of n)for(let[o,a]of[[r,!1],[s,!0]]){if(o==="")continue;let c=document.createElementNS(dU,"tspan");c.textContent=o,a!==i&&c.setAttribute("dy",a?"0.3em":"-0.3em"),a&&c.setAttribute("font-size","0.8em"),i=a,t.append(c)}}}function yU(e){for(let t of e.querySelectorAll("g[aria-label]")){t.setAttribute("role","group");let n=t.getAttribute("aria-description");n&&(t.setAttribute("aria-label",`${t.getAttribute("aria-label")}: ${n}`),t.removeAttribute("aria-description"))}}function xU(e,t,n,i,r){let s=h=>{let f=h.filter(Number.isFinite);return[Math.min(...f),Math.max(...f)]},[o,a]=s(n.map(h=>h.x)),[c,l]=s(n.map(h=>h.y)),u=1.04*Math.max((a-o)/i,(l-c)/r)/2;u>0&&(e.domain=[(o+a)/2-u*i,(o+a)/2+u*i],t.domain=[(c+l)/2-u*r,(c+l)/2+u*r])}function _U(e,t,n,i){return t?80+Math.max((e||n>12?20:34)*n,120):Math.round(Math.min(300,170+i/6))}var A0=(e,t)=>Math.max(0,...e.map(n=>Math.min(String(n).length,t)));function lT(e,t,n){let i=oT(e,t),r=(e.marks??[]).filter(v=>v.type==="rule-x"),s=(e.marks??[]).map(v=>({mark:v,...aT(v,e,t,i,r.indexOf(v))})),o=s.flatMap(v=>v.rows),a=new Set(s.map(v=>v.mark.type)),c=a.has("cells"),l=a.has("diverging-dots"),u=c||a.has("bars")||e.x?.scale==="category",h=c||l||e.y?.scale==="category",f=v=>(e.marks??[]).filter(E=>E.type===v).map(E=>E.value),d=cT(e.y,[...o.map(v=>v.y),...h?[]:f("rule-y")],h);c&&(d.reverse=!0);let m=cT(e.x,o.map(v=>v.x),u),y=l||a.has("dots");y&&!u&&(m.inset=6),y&&!h&&(d.inset=6),u||(m.tickSpacing=56);let g=n<500?22:44,p=v=>{let E=typeof v=="number"?ce(v):jt(v);return E.length>g?`${E.slice(0,g-1)}…`:E};h&&(d.tickFormat=p),u&&(m.tickFormat=p),l&&Object.assign(d,{label:null});let _=u&&A0(m.domain,30)*7*m.domain.length>n-80;_&&(m.tickRotate=-40);let b=o.filter(v=>[v.x,v.y].every(E=>typeof E=="string"||Number.isFinite(E))),x=c||l||a.has("dots")?Vc:Hc,C=e.equal??(/^x( |$)/.test(e.x?.label??"")&&/^y( |$)/.test(e.y?.label??"")),w=o.length>0&&f("rule-x").some(v=>o.every(E=>!(E.x>v))),S=C?Math.min(n-12,480):_U(l,h,d.domain?.length??0,n);C&&xU(m,d,o,n-80,S-68);let R=Kc({width:n,height:S,marginLeft:h?24+6.6*A0(d.domain.map(p),g):62,marginBottom:_?34+4.2*A0(m.domain,g):42,marginTop:26,marginRight:w?58:18,style:{fontSize:"12px",fontFamily:"inherit",overflow:"visible",background:"transparent",color:"inherit"},ariaLabel:e.title,x:m,y:d,marks:[...s.flatMap(v=>v.marks).filter(Boolean),b.length>0?Zc(b,x({x:"x",y:"y",title:v=>pU(v,e),fill:"var(--card)",stroke:"var(--line)",ariaHidden:"true"})):null].filter(Boolean)});R.setAttribute("role","img"),yU(R),gU(R);let M=c?s.flatMap(v=>v.mark.type==="cells"?v.rows.map(E=>E.fill):[]).filter(Number.isFinite):null;return{svg:R,tall:h&&d.domain.length>15,key:s.flatMap(v=>v.key),fills:M,xScale:R.scale("x")}}var C0="http://www.w3.org/2000/svg",vU={line:["path",{d:"M0 6H22","stroke-width":2.2}],dash:["path",{d:"M0 6H22","stroke-width":2,"stroke-dasharray":"5 3"}],band:["rect",{x:0,y:1,width:22,height:10,filled:.25}],dot:["circle",{cx:11,cy:6,r:4,filled:1}],open:["circle",{cx:11,cy:6,r:3.6,"stroke-width":1.7}],triangle:["path",{d:"M11 1L16.5 10.5H5.5Z","stroke-width":1.7}]};function R0({shapes:e,colour:t}){let n=document.createElementNS(C0,"g");for(let i of e){let[r,{filled:s,...o}]=vU[i],a=document.createElementNS(C0,r);for(let[c,l]of Object.entries(o))a.setAttribute(c,l);a.setAttribute("fill",s?t:"none"),s&&a.setAttribute("fill-opacity",s),s!==1&&a.setAttribute("stroke",s?"none":t),n.append(a)}return n}function I0(e){let t=new Map;for(let{label:n,colour:i,shape:r}of e){let s=`${n}|${i}`,o=t.get(s)??{label:n,colour:i,shapes:[]};o.shapes.includes(r)||o.shapes.push(r),t.set(s,o)}return[...t.values()]}function uT(e){let t=I0(e);return t.length===0?null:D("ul",{class:"key"},t.map(n=>{let i=document.createElementNS(C0,"svg");return i.setAttribute("viewBox","0 0 22 12"),i.setAttribute("width",22),i.setAttribute("height",12),i.setAttribute("aria-hidden","true"),i.append(R0(n)),D("li",{},i," ",D("bdi",{},jt(n.label)))}))}function Pf(e,t,n){let i=Array.from({length:11},(s,o)=>Jr(Zr(o/10))).join(", "),r=D("span",{class:"ramp"});return r.style.background=`linear-gradient(to right, ${i})`,D("p",{class:"ramp-line"},ce(e,3),r,ce(t,3),n?` ${n}`:null)}var nl="http://www.w3.org/2000/svg",bU=/var\((--[\w-]+)\)/g;function MU(){let e=document.createElement("div");e.className="always-light",document.body.append(e);let t=getComputedStyle(e),n=new Map;return{get:i=>(n.has(i)||n.set(i,t.getPropertyValue(i).trim()),n.get(i)),done:()=>e.remove()}}function fT(e,t,n,i){let r=document.createElementNS(nl,"text");r.textContent=e;for(let[s,o]of Object.entries({x:t,y:n,"font-size":12,"font-weight":i,"text-anchor":"start",fill:"#1a1d21"}))r.setAttribute(s,o);return r}function hT(e,t,n){let i=MU(),r=e.cloneNode(!0);for(let d of r.querySelectorAll('.cursor, g[aria-label="tip"]'))d.remove();let[s,o]=[Number(e.getAttribute("width")),Number(e.getAttribute("height"))],a=I0(n),c=26+(a.length>0?20:0),l=document.createElementNS(nl,"g");l.setAttribute("transform",`translate(0 ${c})`),l.append(...r.childNodes);let u=document.createElementNS(nl,"rect");for(let[d,m]of Object.entries({width:s,height:o+c,fill:"#fff"}))u.setAttribute(d,m);r.append(u,fT(t,12,20,600));let h=12;for(let d of a){let m=document.createElementNS(nl,"g");m.setAttribute("transform",`translate(${h} 30)`),m.append(R0(d));let y=jt(d.label);r.append(m,fT(y,h+28,41,400)),h+=44+7*y.length}r.append(l),r.setAttribute("xmlns",nl),r.setAttribute("height",o+c),r.setAttribute("viewBox",`0 0 ${s} ${o+c}`),r.setAttribute("font-family","system-ui, sans-serif"),r.style.color="#1a1d21";let f=new XMLSerializer().serializeToString(r).replace(bU,(d,m)=>i.get(m)||"currentColor");return i.done(),f}var wU=380,SU=720,TU="http://www.w3.org/2000/svg";function dT(e,t,n,i){let r=D("div",{class:"drawing"}),s=D("div"),o=e.title||e.id,a=D("p",{id:ho(`${e.id} caption`),class:"caption"},jt(e.caption??""),e.note?D("span",{class:"note"}," ",jt(e.note)):null),c=null,l=0,u=null,h=()=>{if(!u)return;let _=c.xScale.apply(n.time),[b,x]=c.xScale.range;u.style.display=_>b&&_<=x?"":"none",u.setAttribute("x1",_),u.setAttribute("x2",_)},f=()=>{let _=Number(c.svg.getAttribute("height"));u=document.createElementNS(TU,"line");for(let[b,x]of Object.entries({class:"cursor",y1:26,y2:_-42}))u.setAttribute(b,x);c.svg.append(u),c.svg.addEventListener("click",b=>{let x=c.svg.getBoundingClientRect().width/Number(c.svg.getAttribute("width"));n.seek(c.xScale.invert((b.clientX-c.svg.getBoundingClientRect().left)/x))}),h()},d=()=>{c=lT(e,t,l),c.svg.setAttribute("aria-describedby",a.id),r.replaceChildren(c.svg),p.classList.toggle("tall",c.tall);let _=c.key.length>1||c.key.some(b=>b.shape==="triangle");s.replaceChildren(...[_?uT(c.key):null,c.fills?.length>0?Pf(Math.min(...c.fills),Math.max(...c.fills),jt(e.fill_label??"")):null].filter(Boolean)),u=null,e.cursor&&n&&f()};new ResizeObserver(([_])=>{let b=Math.max(280,Math.floor(_.contentRect.width));b===l||_.contentRect.width===0||(l=b,d())}).observe(r),e.cursor&&n&&n.onTime(h);let m=_=>{c&&(l=_,d())},y=0;window.addEventListener("beforeprint",()=>{y=l,m(c?.tall?SU:wU)}),window.addEventListener("afterprint",()=>m(y));let g=()=>(c||(l=720,d()),hT(c.svg,o,c.key)),p=D("figure",{class:e.lead?"chart lead":"chart"},D("div",{class:"chart-head"},D(`h${i}`,{},D("bdi",{},o)),po("SVG",ii(e.id,".svg"),g,"image/svg+xml")),r,s,D("figcaption",{},a));return p.querySelector("button").setAttribute("aria-label",`Save "${o}" as SVG`),{node:p,id:e.id,title:o,svg:g}}var P0=35*Math.PI/180,pT=Math.PI/2-.01,da=class{constructor(t,n={azimuth:.6,elevation:.35}){this.radius=t,this.from=n,this.reset()}reset(){this.azimuth=this.from.azimuth,this.elevation=this.from.elevation,this.zoom=1}turn(t,n){this.azimuth+=t,this.elevation=Math.min(Math.max(this.elevation+n,-pT),pT)}scale(t){this.zoom=Math.min(Math.max(this.zoom*t,.3),12)}distance(t){let n=Math.min(1,t);return this.radius/Math.sin(Math.atan(Math.tan(P0/2)*n))/this.zoom}axes(){let[t,n,i,r]=[Math.sin(this.azimuth),Math.cos(this.azimuth),Math.sin(this.elevation),Math.cos(this.elevation)];return[[n,0,-t],[-t*i,r,-n*i],[t*r,i,n*r]]}projection(t,n){let[i,r,s]=this.axes(),o=this.distance(t/n),a=n/2/Math.tan(P0/2);return(c,l,u)=>{let h=o-(c*s[0]+l*s[1]+u*s[2]),f=h>0?a/h:0;return[t/2+f*(c*i[0]+l*i[1]+u*i[2]),n/2-f*(c*r[0]+l*r[1]+u*r[2]),h,f]}}applyTo(t,n){let i=this.axes()[2],r=this.distance(n);t.fov=P0*180/Math.PI,t.aspect=n,t.near=Math.max(r-2*this.radius,.01*this.radius),t.far=r+2*this.radius,t.position.set(i[0]*r,i[1]*r,i[2]*r),t.lookAt(0,0,0),t.updateProjectionMatrix()}};function mT(e){let t=atob(e),n=new Uint8Array(t.length);for(let i=0;i<t.length;++i)n[i]=t.charCodeAt(i);return n}function L0(e,t){let n=mT(t);return new e(n.buffer,0,Math.floor(n.length/e.BYTES_PER_ELEMENT))}var EU=e=>L0(Uint16Array,e),AU=e=>L0(Uint32Array,e),gT=e=>L0(Float32Array,e);function yT(e){let t=e.shown_atoms??e.atoms,n=EU(e.positions??""),i=t>0?Math.floor(n.length/(3*t)):0;if(i===0)return null;let r=e.ids?AU(e.ids):null,s=(e.colours??[]).map(o=>({...o,values:mT(o.values)})).filter(o=>o.values.length>=i*t);return s.push(CU(i,t,r)),{count:t,frames:i,positions:n,ids:r,colours:s,times:e.times??[],steps:e.steps??[],box:o=>e.box[Math.min(o,e.box.length-1)]}}function CU(e,t,n){let i=new Uint8Array(t),r=n?n.reduce((s,o)=>Math.max(s,o),1):Math.max(t-1,1);for(let s=0;s<t;++s)i[s]=Math.round(255*(n?n[s]:s)/r);return{name:"id",label:"number of the atom",low:0,high:r,values:i,still:!0}}function Lf(e,t,n){return e.still?e.values:e.values.subarray(t*n,(t+1)*n)}var Nf=class{constructor(t,n,i){this.gl=t,this.count=n,this.draw=i,this.budget=n,this.movedAt=-1/0,this.busy=!1,this.wanted=!1}moved(){this.movedAt=performance.now(),clearTimeout(this.rest),this.rest=setTimeout(()=>this.changed(),260),this.changed()}changed(){this.wanted||(this.wanted=!0,this.busy||requestAnimationFrame(()=>this.picture()))}drawNow(){this.busy||(this.wanted=!0,this.picture())}picture(){if(!this.wanted||this.busy)return;this.wanted=!1,this.busy=!0;let n=performance.now()-this.movedAt<250?this.budget:this.count,i=performance.now();this.draw(n);let{gl:r}=this,s=r.fenceSync(r.SYNC_GPU_COMMANDS_COMPLETE,0);r.flush();let o=()=>{if(!(s===null||r.isContextLost()||r.getSyncParameter(s,r.SYNC_STATUS)===r.SIGNALED)&&performance.now()-i<2e3){setTimeout(o,2);return}s&&r.deleteSync(s),this.busy=!1,this.adapt(n,performance.now()-i),this.wanted&&requestAnimationFrame(()=>this.picture())};setTimeout(o,0)}adapt(t,n){n>80?this.budget=Math.max(Math.min(2e3,this.count),Math.round(t*.8*80/n)):n<80/2&&t>=this.budget&&(this.budget=Math.min(this.count,Math.round(this.budget*1.3)))}};function xT(e,t,n,i,r,s){let o=-1,a=1/0;for(let c=0;3*c<e.length;++c){let[l,u,h,f]=i(...[0,1,2].map(d=>(e[3*c+d]/65536-.5)*t[d]));f>0&&h<a&&Math.hypot(l-r,u-s)<=n*f&&(o=c,a=h)}return o}function _T(e,t){let n=new Float32Array(Math.max(0,e.frames-1)*6);for(let i=0;i+1<e.frames;++i){let r=e.box(i);for(let s=0;s<3;++s){let o=e.positions[3*(i*e.count+t)+s],c=e.positions[3*((i+1)*e.count+t)+s]-o<<16>>16;n[6*i+s]=(o/65536-.5)*r[s],n[6*i+3+s]=((o+c)/65536-.5)*r[s]}}return n}var RU=[["0.25","¼ ×"],["0.5","½ ×"],["1","1 ×"],["2","2 ×"],["4","4 ×"]],pa=class{constructor(t,n,i,r){this.seconds=r,this.frames=t,this.times=n,this.unit=i,this.frame=0,this.playing=!1,this.listeners=[],this.ready=()=>!0,this.speed=1,this.node=this.controls(),this.show(0)}get time(){return this.times[this.frame]??this.frame}onTime(t){this.listeners.push(t)}show(t){this.frame=Math.min(Math.max(t,0),this.frames-1);let n=`t = ${ce(this.time,5)}${this.unit?` ${this.unit}`:""}`;this.slider.value=String(this.frame),this.slider.setAttribute("aria-valuetext",`frame ${this.frame+1} of ${this.frames}, ${n}`),this.words.textContent=`${n}  ·  ${this.frame+1}/${this.frames}`;for(let i of this.listeners)i(this.frame)}seek(t){let n=0;for(let i=1;i<this.frames;++i)Math.abs(this.times[i]-t)<Math.abs(this.times[n]-t)&&(n=i);this.show(n)}play(){if(this.playing)return;this.playing=!0,this.label(),this.frame===this.frames-1&&this.show(0);let t=this.frame,n=null,i=this.frame,r=()=>this.frame!==i,s=o=>{if(!this.playing)return;r()&&(t=this.frame),t+=n===null?0:Math.min(o-n,500)/1e3*this.speed*(this.frames/this.seconds),n=o;let a=Math.floor(t)%this.frames;a!==this.frame&&this.ready()&&this.show(a),i=this.frame,requestAnimationFrame(s)};requestAnimationFrame(s)}pause(){this.playing=!1,this.label()}label(){this.button.textContent=this.playing?"❚❚":"►",this.button.setAttribute("aria-label",this.playing?"Pause":"Play")}controls(){this.button=D("button",{type:"button",class:"play",onclick:()=>this.playing?this.pause():this.play()}),this.label(),this.slider=D("input",{type:"range",min:0,max:this.frames-1,step:1,value:0,"aria-label":"Frame"}),this.slider.addEventListener("input",()=>this.show(Number(this.slider.value))),this.words=D("output",{class:"time"});let t=D("select",{"aria-label":"Speed of the playback"},RU.map(([n,i])=>D("option",{value:n,selected:n==="1"},i)));return t.addEventListener("change",()=>this.speed=Number(t.value)),D("div",{class:"playback",hidden:this.frames<2},this.button,this.slider,this.words,t)}};var Ax="170";var IU=0,vT=1,PU=2;var TE=1,LU=2,_r=3,cs=0,Mn=1,br=2,os=0,Ia=1,bT=2,MT=3,wT=4,NU=5,eo=100,DU=101,UU=102,FU=103,OU=104,BU=200,kU=201,zU=202,VU=203,uy=204,fy=205,HU=206,GU=207,WU=208,$U=209,XU=210,YU=211,qU=212,ZU=213,JU=214,hy=0,dy=1,py=2,Da=3,my=4,gy=5,yy=6,xy=7,EE=0,KU=1,jU=2,as=0,QU=1,t4=2,e4=3,n4=4,i4=5,r4=6,s4=7;var AE=300,Ua=301,Fa=302,_y=303,vy=304,Fh=306,by=1e3,ro=1001,My=1002,Ln=1003,o4=1004;var Df=1005;var Wi=1006,N0=1007;var so=1008;var Tr=1009,CE=1010,RE=1011,hl=1012,Cx=1013,oo=1014,Mr=1015,gl=1016,Rx=1017,Ix=1018,Oa=1020,IE=35902,PE=1021,LE=1022,Pn=1023,NE=1024,DE=1025,Pa=1026,Ba=1027,UE=1028,Px=1029,FE=1030,Lx=1031;var Nx=1033,oh=33776,ah=33777,ch=33778,lh=33779,wy=35840,Sy=35841,Ty=35842,Ey=35843,Ay=36196,Cy=37492,Ry=37496,Iy=37808,Py=37809,Ly=37810,Ny=37811,Dy=37812,Uy=37813,Fy=37814,Oy=37815,By=37816,ky=37817,zy=37818,Vy=37819,Hy=37820,Gy=37821,uh=36492,Wy=36494,$y=36495,OE=36283,Xy=36284,Yy=36285,qy=36286;var fh=2300,Zy=2301,D0=2302,ST=2400,TT=2401,ET=2402;var a4=3200,c4=3201;var l4=0,u4=1,rs="",ti="srgb",Ha="srgb-linear",Oh="linear",pe="srgb";var ma=7680;var AT=519,f4=512,h4=513,d4=514,BE=515,p4=516,m4=517,g4=518,y4=519,CT=35044;var hh="300 es",wr=2e3,dh=2001,ls=class{addEventListener(t,n){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(n)===-1&&i[t].push(n)}hasEventListener(t,n){if(this._listeners===void 0)return!1;let i=this._listeners;return i[t]!==void 0&&i[t].indexOf(n)!==-1}removeEventListener(t,n){if(this._listeners===void 0)return;let r=this._listeners[t];if(r!==void 0){let s=r.indexOf(n);s!==-1&&r.splice(s,1)}}dispatchEvent(t){if(this._listeners===void 0)return;let i=this._listeners[t.type];if(i!==void 0){t.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,t);t.target=null}}},nn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var U0=Math.PI/180,Jy=180/Math.PI;function yl(){let e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(nn[e&255]+nn[e>>8&255]+nn[e>>16&255]+nn[e>>24&255]+"-"+nn[t&255]+nn[t>>8&255]+"-"+nn[t>>16&15|64]+nn[t>>24&255]+"-"+nn[n&63|128]+nn[n>>8&255]+"-"+nn[n>>16&255]+nn[n>>24&255]+nn[i&255]+nn[i>>8&255]+nn[i>>16&255]+nn[i>>24&255]).toLowerCase()}function bn(e,t,n){return Math.max(t,Math.min(n,e))}function x4(e,t){return(e%t+t)%t}function F0(e,t,n){return(1-n)*e+n*t}function il(e,t){switch(t.constructor){case Float32Array:return e;case Uint32Array:return e/4294967295;case Uint16Array:return e/65535;case Uint8Array:return e/255;case Int32Array:return Math.max(e/2147483647,-1);case Int16Array:return Math.max(e/32767,-1);case Int8Array:return Math.max(e/127,-1);default:throw new Error("Invalid component type.")}}function vn(e,t){switch(t.constructor){case Float32Array:return e;case Uint32Array:return Math.round(e*4294967295);case Uint16Array:return Math.round(e*65535);case Uint8Array:return Math.round(e*255);case Int32Array:return Math.round(e*2147483647);case Int16Array:return Math.round(e*32767);case Int8Array:return Math.round(e*127);default:throw new Error("Invalid component type.")}}var le=class e{constructor(t=0,n=0){e.prototype.isVector2=!0,this.x=t,this.y=n}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,n){return this.x=t,this.y=n,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,n){switch(t){case 0:this.x=n;break;case 1:this.y=n;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,n){return this.x=t.x+n.x,this.y=t.y+n.y,this}addScaledVector(t,n){return this.x+=t.x*n,this.y+=t.y*n,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,n){return this.x=t.x-n.x,this.y=t.y-n.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let n=this.x,i=this.y,r=t.elements;return this.x=r[0]*n+r[3]*i+r[6],this.y=r[1]*n+r[4]*i+r[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,n){return this.x=Math.max(t.x,Math.min(n.x,this.x)),this.y=Math.max(t.y,Math.min(n.y,this.y)),this}clampScalar(t,n){return this.x=Math.max(t,Math.min(n,this.x)),this.y=Math.max(t,Math.min(n,this.y)),this}clampLength(t,n){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(n,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let n=Math.sqrt(this.lengthSq()*t.lengthSq());if(n===0)return Math.PI/2;let i=this.dot(t)/n;return Math.acos(bn(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let n=this.x-t.x,i=this.y-t.y;return n*n+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,n){return this.x+=(t.x-this.x)*n,this.y+=(t.y-this.y)*n,this}lerpVectors(t,n,i){return this.x=t.x+(n.x-t.x)*i,this.y=t.y+(n.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,n=0){return this.x=t[n],this.y=t[n+1],this}toArray(t=[],n=0){return t[n]=this.x,t[n+1]=this.y,t}fromBufferAttribute(t,n){return this.x=t.getX(n),this.y=t.getY(n),this}rotateAround(t,n){let i=Math.cos(n),r=Math.sin(n),s=this.x-t.x,o=this.y-t.y;return this.x=s*i-o*r+t.x,this.y=s*r+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Wt=class e{constructor(t,n,i,r,s,o,a,c,l){e.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,n,i,r,s,o,a,c,l)}set(t,n,i,r,s,o,a,c,l){let u=this.elements;return u[0]=t,u[1]=r,u[2]=a,u[3]=n,u[4]=s,u[5]=c,u[6]=i,u[7]=o,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let n=this.elements,i=t.elements;return n[0]=i[0],n[1]=i[1],n[2]=i[2],n[3]=i[3],n[4]=i[4],n[5]=i[5],n[6]=i[6],n[7]=i[7],n[8]=i[8],this}extractBasis(t,n,i){return t.setFromMatrix3Column(this,0),n.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let n=t.elements;return this.set(n[0],n[4],n[8],n[1],n[5],n[9],n[2],n[6],n[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,n){let i=t.elements,r=n.elements,s=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],u=i[4],h=i[7],f=i[2],d=i[5],m=i[8],y=r[0],g=r[3],p=r[6],_=r[1],b=r[4],x=r[7],C=r[2],w=r[5],S=r[8];return s[0]=o*y+a*_+c*C,s[3]=o*g+a*b+c*w,s[6]=o*p+a*x+c*S,s[1]=l*y+u*_+h*C,s[4]=l*g+u*b+h*w,s[7]=l*p+u*x+h*S,s[2]=f*y+d*_+m*C,s[5]=f*g+d*b+m*w,s[8]=f*p+d*x+m*S,this}multiplyScalar(t){let n=this.elements;return n[0]*=t,n[3]*=t,n[6]*=t,n[1]*=t,n[4]*=t,n[7]*=t,n[2]*=t,n[5]*=t,n[8]*=t,this}determinant(){let t=this.elements,n=t[0],i=t[1],r=t[2],s=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8];return n*o*u-n*a*l-i*s*u+i*a*c+r*s*l-r*o*c}invert(){let t=this.elements,n=t[0],i=t[1],r=t[2],s=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],h=u*o-a*l,f=a*c-u*s,d=l*s-o*c,m=n*h+i*f+r*d;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/m;return t[0]=h*y,t[1]=(r*l-u*i)*y,t[2]=(a*i-r*o)*y,t[3]=f*y,t[4]=(u*n-r*c)*y,t[5]=(r*s-a*n)*y,t[6]=d*y,t[7]=(i*c-l*n)*y,t[8]=(o*n-i*s)*y,this}transpose(){let t,n=this.elements;return t=n[1],n[1]=n[3],n[3]=t,t=n[2],n[2]=n[6],n[6]=t,t=n[5],n[5]=n[7],n[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let n=this.elements;return t[0]=n[0],t[1]=n[3],t[2]=n[6],t[3]=n[1],t[4]=n[4],t[5]=n[7],t[6]=n[2],t[7]=n[5],t[8]=n[8],this}setUvTransform(t,n,i,r,s,o,a){let c=Math.cos(s),l=Math.sin(s);return this.set(i*c,i*l,-i*(c*o+l*a)+o+t,-r*l,r*c,-r*(-l*o+c*a)+a+n,0,0,1),this}scale(t,n){return this.premultiply(O0.makeScale(t,n)),this}rotate(t){return this.premultiply(O0.makeRotation(-t)),this}translate(t,n){return this.premultiply(O0.makeTranslation(t,n)),this}makeTranslation(t,n){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,n,0,0,1),this}makeRotation(t){let n=Math.cos(t),i=Math.sin(t);return this.set(n,-i,0,i,n,0,0,0,1),this}makeScale(t,n){return this.set(t,0,0,0,n,0,0,0,1),this}equals(t){let n=this.elements,i=t.elements;for(let r=0;r<9;r++)if(n[r]!==i[r])return!1;return!0}fromArray(t,n=0){for(let i=0;i<9;i++)this.elements[i]=t[i+n];return this}toArray(t=[],n=0){let i=this.elements;return t[n]=i[0],t[n+1]=i[1],t[n+2]=i[2],t[n+3]=i[3],t[n+4]=i[4],t[n+5]=i[5],t[n+6]=i[6],t[n+7]=i[7],t[n+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},O0=new Wt;function kE(e){for(let t=e.length-1;t>=0;--t)if(e[t]>=65535)return!0;return!1}function ph(e){return document.createElementNS("http://www.w3.org/1999/xhtml",e)}function _4(){let e=ph("canvas");return e.style.display="block",e}var RT={};function ll(e){e in RT||(RT[e]=!0,console.warn(e))}function v4(e,t,n){return new Promise(function(i,r){function s(){switch(e.clientWaitSync(t,e.SYNC_FLUSH_COMMANDS_BIT,0)){case e.WAIT_FAILED:r();break;case e.TIMEOUT_EXPIRED:setTimeout(s,n);break;default:i()}}setTimeout(s,n)})}function b4(e){let t=e.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function M4(e){let t=e.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}var ee={enabled:!0,workingColorSpace:Ha,spaces:{},convert:function(e,t,n){return this.enabled===!1||t===n||!t||!n||(this.spaces[t].transfer===pe&&(e.r=Sr(e.r),e.g=Sr(e.g),e.b=Sr(e.b)),this.spaces[t].primaries!==this.spaces[n].primaries&&(e.applyMatrix3(this.spaces[t].toXYZ),e.applyMatrix3(this.spaces[n].fromXYZ)),this.spaces[n].transfer===pe&&(e.r=La(e.r),e.g=La(e.g),e.b=La(e.b))),e},fromWorkingColorSpace:function(e,t){return this.convert(e,this.workingColorSpace,t)},toWorkingColorSpace:function(e,t){return this.convert(e,t,this.workingColorSpace)},getPrimaries:function(e){return this.spaces[e].primaries},getTransfer:function(e){return e===rs?Oh:this.spaces[e].transfer},getLuminanceCoefficients:function(e,t=this.workingColorSpace){return e.fromArray(this.spaces[t].luminanceCoefficients)},define:function(e){Object.assign(this.spaces,e)},_getMatrix:function(e,t,n){return e.copy(this.spaces[t].toXYZ).multiply(this.spaces[n].fromXYZ)},_getDrawingBufferColorSpace:function(e){return this.spaces[e].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(e=this.workingColorSpace){return this.spaces[e].workingColorSpaceConfig.unpackColorSpace}};function Sr(e){return e<.04045?e*.0773993808:Math.pow(e*.9478672986+.0521327014,2.4)}function La(e){return e<.0031308?e*12.92:1.055*Math.pow(e,.41666)-.055}var IT=[.64,.33,.3,.6,.15,.06],PT=[.2126,.7152,.0722],LT=[.3127,.329],NT=new Wt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),DT=new Wt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);ee.define({[Ha]:{primaries:IT,whitePoint:LT,transfer:Oh,toXYZ:NT,fromXYZ:DT,luminanceCoefficients:PT,workingColorSpaceConfig:{unpackColorSpace:ti},outputColorSpaceConfig:{drawingBufferColorSpace:ti}},[ti]:{primaries:IT,whitePoint:LT,transfer:pe,toXYZ:NT,fromXYZ:DT,luminanceCoefficients:PT,outputColorSpaceConfig:{drawingBufferColorSpace:ti}}});var ga,Ky=class{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{ga===void 0&&(ga=ph("canvas")),ga.width=t.width,ga.height=t.height;let i=ga.getContext("2d");t instanceof ImageData?i.putImageData(t,0,0):i.drawImage(t,0,0,t.width,t.height),n=ga}return n.width>2048||n.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),n.toDataURL("image/jpeg",.6)):n.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let n=ph("canvas");n.width=t.width,n.height=t.height;let i=n.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let r=i.getImageData(0,0,t.width,t.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Sr(s[o]/255)*255;return i.putImageData(r,0,0),n}else if(t.data){let n=t.data.slice(0);for(let i=0;i<n.length;i++)n instanceof Uint8Array||n instanceof Uint8ClampedArray?n[i]=Math.floor(Sr(n[i]/255)*255):n[i]=Sr(n[i]);return{data:n,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},w4=0,mh=class{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:w4++}),this.uuid=yl(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let n=t===void 0||typeof t=="string";if(!n&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(B0(r[o].image)):s.push(B0(r[o]))}else s=B0(r);i.url=s}return n||(t.images[this.uuid]=i),i}};function B0(e){return typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap?Ky.getDataURL(e):e.data?{data:Array.from(e.data),width:e.width,height:e.height,type:e.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var S4=0,Nn=class e extends ls{constructor(t=e.DEFAULT_IMAGE,n=e.DEFAULT_MAPPING,i=ro,r=ro,s=Wi,o=so,a=Pn,c=Tr,l=e.DEFAULT_ANISOTROPY,u=rs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:S4++}),this.uuid=yl(),this.name="",this.source=new mh(t),this.mipmaps=[],this.mapping=n,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new le(0,0),this.repeat=new le(1,1),this.center=new le(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Wt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){let n=t===void 0||typeof t=="string";if(!n&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),n||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==AE)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case by:t.x=t.x-Math.floor(t.x);break;case ro:t.x=t.x<0?0:1;break;case My:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case by:t.y=t.y-Math.floor(t.y);break;case ro:t.y=t.y<0?0:1;break;case My:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Nn.DEFAULT_IMAGE=null;Nn.DEFAULT_MAPPING=AE;Nn.DEFAULT_ANISOTROPY=1;var Ne=class e{constructor(t=0,n=0,i=0,r=1){e.prototype.isVector4=!0,this.x=t,this.y=n,this.z=i,this.w=r}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,n,i,r){return this.x=t,this.y=n,this.z=i,this.w=r,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,n){switch(t){case 0:this.x=n;break;case 1:this.y=n;break;case 2:this.z=n;break;case 3:this.w=n;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,n){return this.x=t.x+n.x,this.y=t.y+n.y,this.z=t.z+n.z,this.w=t.w+n.w,this}addScaledVector(t,n){return this.x+=t.x*n,this.y+=t.y*n,this.z+=t.z*n,this.w+=t.w*n,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,n){return this.x=t.x-n.x,this.y=t.y-n.y,this.z=t.z-n.z,this.w=t.w-n.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let n=this.x,i=this.y,r=this.z,s=this.w,o=t.elements;return this.x=o[0]*n+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*n+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*n+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*n+o[7]*i+o[11]*r+o[15]*s,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let n=Math.sqrt(1-t.w*t.w);return n<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/n,this.y=t.y/n,this.z=t.z/n),this}setAxisAngleFromRotationMatrix(t){let n,i,r,s,c=t.elements,l=c[0],u=c[4],h=c[8],f=c[1],d=c[5],m=c[9],y=c[2],g=c[6],p=c[10];if(Math.abs(u-f)<.01&&Math.abs(h-y)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+y)<.1&&Math.abs(m+g)<.1&&Math.abs(l+d+p-3)<.1)return this.set(1,0,0,0),this;n=Math.PI;let b=(l+1)/2,x=(d+1)/2,C=(p+1)/2,w=(u+f)/4,S=(h+y)/4,R=(m+g)/4;return b>x&&b>C?b<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(b),r=w/i,s=S/i):x>C?x<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(x),i=w/r,s=R/r):C<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(C),i=S/s,r=R/s),this.set(i,r,s,n),this}let _=Math.sqrt((g-m)*(g-m)+(h-y)*(h-y)+(f-u)*(f-u));return Math.abs(_)<.001&&(_=1),this.x=(g-m)/_,this.y=(h-y)/_,this.z=(f-u)/_,this.w=Math.acos((l+d+p-1)/2),this}setFromMatrixPosition(t){let n=t.elements;return this.x=n[12],this.y=n[13],this.z=n[14],this.w=n[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,n){return this.x=Math.max(t.x,Math.min(n.x,this.x)),this.y=Math.max(t.y,Math.min(n.y,this.y)),this.z=Math.max(t.z,Math.min(n.z,this.z)),this.w=Math.max(t.w,Math.min(n.w,this.w)),this}clampScalar(t,n){return this.x=Math.max(t,Math.min(n,this.x)),this.y=Math.max(t,Math.min(n,this.y)),this.z=Math.max(t,Math.min(n,this.z)),this.w=Math.max(t,Math.min(n,this.w)),this}clampLength(t,n){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(n,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,n){return this.x+=(t.x-this.x)*n,this.y+=(t.y-this.y)*n,this.z+=(t.z-this.z)*n,this.w+=(t.w-this.w)*n,this}lerpVectors(t,n,i){return this.x=t.x+(n.x-t.x)*i,this.y=t.y+(n.y-t.y)*i,this.z=t.z+(n.z-t.z)*i,this.w=t.w+(n.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,n=0){return this.x=t[n],this.y=t[n+1],this.z=t[n+2],this.w=t[n+3],this}toArray(t=[],n=0){return t[n]=this.x,t[n+1]=this.y,t[n+2]=this.z,t[n+3]=this.w,t}fromBufferAttribute(t,n){return this.x=t.getX(n),this.y=t.getY(n),this.z=t.getZ(n),this.w=t.getW(n),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},jy=class extends ls{constructor(t=1,n=1,i={}){super(),this.isRenderTarget=!0,this.width=t,this.height=n,this.depth=1,this.scissor=new Ne(0,0,t,n),this.scissorTest=!1,this.viewport=new Ne(0,0,t,n);let r={width:t,height:n,depth:1};i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Wi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},i);let s=new Nn(r,i.mapping,i.wrapS,i.wrapT,i.magFilter,i.minFilter,i.format,i.type,i.anisotropy,i.colorSpace);s.flipY=!1,s.generateMipmaps=i.generateMipmaps,s.internalFormat=i.internalFormat,this.textures=[];let o=i.count;for(let a=0;a<o;a++)this.textures[a]=s.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.depthTexture=i.depthTexture,this.samples=i.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,n,i=1){if(this.width!==t||this.height!==n||this.depth!==i){this.width=t,this.height=n,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=t,this.textures[r].image.height=n,this.textures[r].image.depth=i;this.dispose()}this.viewport.set(0,0,t,n),this.scissor.set(0,0,t,n)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let i=0,r=t.textures.length;i<r;i++)this.textures[i]=t.textures[i].clone(),this.textures[i].isRenderTargetTexture=!0;let n=Object.assign({},t.texture.image);return this.texture.source=new mh(n),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Er=class extends jy{constructor(t=1,n=1,i={}){super(t,n,i),this.isWebGLRenderTarget=!0}},gh=class extends Nn{constructor(t=null,n=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:n,height:i,depth:r},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=ro,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Qy=class extends Nn{constructor(t=null,n=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:n,height:i,depth:r},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=ro,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var us=class{constructor(t=0,n=0,i=0,r=1){this.isQuaternion=!0,this._x=t,this._y=n,this._z=i,this._w=r}static slerpFlat(t,n,i,r,s,o,a){let c=i[r+0],l=i[r+1],u=i[r+2],h=i[r+3],f=s[o+0],d=s[o+1],m=s[o+2],y=s[o+3];if(a===0){t[n+0]=c,t[n+1]=l,t[n+2]=u,t[n+3]=h;return}if(a===1){t[n+0]=f,t[n+1]=d,t[n+2]=m,t[n+3]=y;return}if(h!==y||c!==f||l!==d||u!==m){let g=1-a,p=c*f+l*d+u*m+h*y,_=p>=0?1:-1,b=1-p*p;if(b>Number.EPSILON){let C=Math.sqrt(b),w=Math.atan2(C,p*_);g=Math.sin(g*w)/C,a=Math.sin(a*w)/C}let x=a*_;if(c=c*g+f*x,l=l*g+d*x,u=u*g+m*x,h=h*g+y*x,g===1-a){let C=1/Math.sqrt(c*c+l*l+u*u+h*h);c*=C,l*=C,u*=C,h*=C}}t[n]=c,t[n+1]=l,t[n+2]=u,t[n+3]=h}static multiplyQuaternionsFlat(t,n,i,r,s,o){let a=i[r],c=i[r+1],l=i[r+2],u=i[r+3],h=s[o],f=s[o+1],d=s[o+2],m=s[o+3];return t[n]=a*m+u*h+c*d-l*f,t[n+1]=c*m+u*f+l*h-a*d,t[n+2]=l*m+u*d+a*f-c*h,t[n+3]=u*m-a*h-c*f-l*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,n,i,r){return this._x=t,this._y=n,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,n=!0){let i=t._x,r=t._y,s=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(i/2),u=a(r/2),h=a(s/2),f=c(i/2),d=c(r/2),m=c(s/2);switch(o){case"XYZ":this._x=f*u*h+l*d*m,this._y=l*d*h-f*u*m,this._z=l*u*m+f*d*h,this._w=l*u*h-f*d*m;break;case"YXZ":this._x=f*u*h+l*d*m,this._y=l*d*h-f*u*m,this._z=l*u*m-f*d*h,this._w=l*u*h+f*d*m;break;case"ZXY":this._x=f*u*h-l*d*m,this._y=l*d*h+f*u*m,this._z=l*u*m+f*d*h,this._w=l*u*h-f*d*m;break;case"ZYX":this._x=f*u*h-l*d*m,this._y=l*d*h+f*u*m,this._z=l*u*m-f*d*h,this._w=l*u*h+f*d*m;break;case"YZX":this._x=f*u*h+l*d*m,this._y=l*d*h+f*u*m,this._z=l*u*m-f*d*h,this._w=l*u*h-f*d*m;break;case"XZY":this._x=f*u*h-l*d*m,this._y=l*d*h-f*u*m,this._z=l*u*m+f*d*h,this._w=l*u*h+f*d*m;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return n===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,n){let i=n/2,r=Math.sin(i);return this._x=t.x*r,this._y=t.y*r,this._z=t.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let n=t.elements,i=n[0],r=n[4],s=n[8],o=n[1],a=n[5],c=n[9],l=n[2],u=n[6],h=n[10],f=i+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-c)*d,this._y=(s-l)*d,this._z=(o-r)*d}else if(i>a&&i>h){let d=2*Math.sqrt(1+i-a-h);this._w=(u-c)/d,this._x=.25*d,this._y=(r+o)/d,this._z=(s+l)/d}else if(a>h){let d=2*Math.sqrt(1+a-i-h);this._w=(s-l)/d,this._x=(r+o)/d,this._y=.25*d,this._z=(c+u)/d}else{let d=2*Math.sqrt(1+h-i-a);this._w=(o-r)/d,this._x=(s+l)/d,this._y=(c+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,n){let i=t.dot(n)+1;return i<Number.EPSILON?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*n.z-t.z*n.y,this._y=t.z*n.x-t.x*n.z,this._z=t.x*n.y-t.y*n.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(bn(this.dot(t),-1,1)))}rotateTowards(t,n){let i=this.angleTo(t);if(i===0)return this;let r=Math.min(1,n/i);return this.slerp(t,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,n){let i=t._x,r=t._y,s=t._z,o=t._w,a=n._x,c=n._y,l=n._z,u=n._w;return this._x=i*u+o*a+r*l-s*c,this._y=r*u+o*c+s*a-i*l,this._z=s*u+o*l+i*c-r*a,this._w=o*u-i*a-r*c-s*l,this._onChangeCallback(),this}slerp(t,n){if(n===0)return this;if(n===1)return this.copy(t);let i=this._x,r=this._y,s=this._z,o=this._w,a=o*t._w+i*t._x+r*t._y+s*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=i,this._y=r,this._z=s,this;let c=1-a*a;if(c<=Number.EPSILON){let d=1-n;return this._w=d*o+n*this._w,this._x=d*i+n*this._x,this._y=d*r+n*this._y,this._z=d*s+n*this._z,this.normalize(),this}let l=Math.sqrt(c),u=Math.atan2(l,a),h=Math.sin((1-n)*u)/l,f=Math.sin(n*u)/l;return this._w=o*h+this._w*f,this._x=i*h+this._x*f,this._y=r*h+this._y*f,this._z=s*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,n,i){return this.copy(t).slerp(n,i)}random(){let t=2*Math.PI*Math.random(),n=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(t),r*Math.cos(t),s*Math.sin(n),s*Math.cos(n))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,n=0){return this._x=t[n],this._y=t[n+1],this._z=t[n+2],this._w=t[n+3],this._onChangeCallback(),this}toArray(t=[],n=0){return t[n]=this._x,t[n+1]=this._y,t[n+2]=this._z,t[n+3]=this._w,t}fromBufferAttribute(t,n){return this._x=t.getX(n),this._y=t.getY(n),this._z=t.getZ(n),this._w=t.getW(n),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Y=class e{constructor(t=0,n=0,i=0){e.prototype.isVector3=!0,this.x=t,this.y=n,this.z=i}set(t,n,i){return i===void 0&&(i=this.z),this.x=t,this.y=n,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,n){switch(t){case 0:this.x=n;break;case 1:this.y=n;break;case 2:this.z=n;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,n){return this.x=t.x+n.x,this.y=t.y+n.y,this.z=t.z+n.z,this}addScaledVector(t,n){return this.x+=t.x*n,this.y+=t.y*n,this.z+=t.z*n,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,n){return this.x=t.x-n.x,this.y=t.y-n.y,this.z=t.z-n.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,n){return this.x=t.x*n.x,this.y=t.y*n.y,this.z=t.z*n.z,this}applyEuler(t){return this.applyQuaternion(UT.setFromEuler(t))}applyAxisAngle(t,n){return this.applyQuaternion(UT.setFromAxisAngle(t,n))}applyMatrix3(t){let n=this.x,i=this.y,r=this.z,s=t.elements;return this.x=s[0]*n+s[3]*i+s[6]*r,this.y=s[1]*n+s[4]*i+s[7]*r,this.z=s[2]*n+s[5]*i+s[8]*r,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let n=this.x,i=this.y,r=this.z,s=t.elements,o=1/(s[3]*n+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*n+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*n+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*n+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(t){let n=this.x,i=this.y,r=this.z,s=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*r-a*i),u=2*(a*n-s*r),h=2*(s*i-o*n);return this.x=n+c*l+o*h-a*u,this.y=i+c*u+a*l-s*h,this.z=r+c*h+s*u-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let n=this.x,i=this.y,r=this.z,s=t.elements;return this.x=s[0]*n+s[4]*i+s[8]*r,this.y=s[1]*n+s[5]*i+s[9]*r,this.z=s[2]*n+s[6]*i+s[10]*r,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,n){return this.x=Math.max(t.x,Math.min(n.x,this.x)),this.y=Math.max(t.y,Math.min(n.y,this.y)),this.z=Math.max(t.z,Math.min(n.z,this.z)),this}clampScalar(t,n){return this.x=Math.max(t,Math.min(n,this.x)),this.y=Math.max(t,Math.min(n,this.y)),this.z=Math.max(t,Math.min(n,this.z)),this}clampLength(t,n){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(n,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,n){return this.x+=(t.x-this.x)*n,this.y+=(t.y-this.y)*n,this.z+=(t.z-this.z)*n,this}lerpVectors(t,n,i){return this.x=t.x+(n.x-t.x)*i,this.y=t.y+(n.y-t.y)*i,this.z=t.z+(n.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,n){let i=t.x,r=t.y,s=t.z,o=n.x,a=n.y,c=n.z;return this.x=r*c-s*a,this.y=s*o-i*c,this.z=i*a-r*o,this}projectOnVector(t){let n=t.lengthSq();if(n===0)return this.set(0,0,0);let i=t.dot(this)/n;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return k0.copy(this).projectOnVector(t),this.sub(k0)}reflect(t){return this.sub(k0.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let n=Math.sqrt(this.lengthSq()*t.lengthSq());if(n===0)return Math.PI/2;let i=this.dot(t)/n;return Math.acos(bn(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let n=this.x-t.x,i=this.y-t.y,r=this.z-t.z;return n*n+i*i+r*r}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,n,i){let r=Math.sin(n)*t;return this.x=r*Math.sin(i),this.y=Math.cos(n)*t,this.z=r*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,n,i){return this.x=t*Math.sin(n),this.y=i,this.z=t*Math.cos(n),this}setFromMatrixPosition(t){let n=t.elements;return this.x=n[12],this.y=n[13],this.z=n[14],this}setFromMatrixScale(t){let n=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),r=this.setFromMatrixColumn(t,2).length();return this.x=n,this.y=i,this.z=r,this}setFromMatrixColumn(t,n){return this.fromArray(t.elements,n*4)}setFromMatrix3Column(t,n){return this.fromArray(t.elements,n*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,n=0){return this.x=t[n],this.y=t[n+1],this.z=t[n+2],this}toArray(t=[],n=0){return t[n]=this.x,t[n+1]=this.y,t[n+2]=this.z,t}fromBufferAttribute(t,n){return this.x=t.getX(n),this.y=t.getY(n),this.z=t.getZ(n),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,n=Math.random()*2-1,i=Math.sqrt(1-n*n);return this.x=i*Math.cos(t),this.y=n,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},k0=new Y,UT=new us,ao=class{constructor(t=new Y(1/0,1/0,1/0),n=new Y(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=n}set(t,n){return this.min.copy(t),this.max.copy(n),this}setFromArray(t){this.makeEmpty();for(let n=0,i=t.length;n<i;n+=3)this.expandByPoint(pi.fromArray(t,n));return this}setFromBufferAttribute(t){this.makeEmpty();for(let n=0,i=t.count;n<i;n++)this.expandByPoint(pi.fromBufferAttribute(t,n));return this}setFromPoints(t){this.makeEmpty();for(let n=0,i=t.length;n<i;n++)this.expandByPoint(t[n]);return this}setFromCenterAndSize(t,n){let i=pi.copy(n).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,n=!1){return this.makeEmpty(),this.expandByObject(t,n)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,n=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let s=i.getAttribute("position");if(n===!0&&s!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=s.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,pi):pi.fromBufferAttribute(s,o),pi.applyMatrix4(t.matrixWorld),this.expandByPoint(pi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Uf.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Uf.copy(i.boundingBox)),Uf.applyMatrix4(t.matrixWorld),this.union(Uf)}let r=t.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],n);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,n){return n.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,pi),pi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let n,i;return t.normal.x>0?(n=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(n=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(n+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(n+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(n+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(n+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),n<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(rl),Ff.subVectors(this.max,rl),ya.subVectors(t.a,rl),xa.subVectors(t.b,rl),_a.subVectors(t.c,rl),jr.subVectors(xa,ya),Qr.subVectors(_a,xa),qs.subVectors(ya,_a);let n=[0,-jr.z,jr.y,0,-Qr.z,Qr.y,0,-qs.z,qs.y,jr.z,0,-jr.x,Qr.z,0,-Qr.x,qs.z,0,-qs.x,-jr.y,jr.x,0,-Qr.y,Qr.x,0,-qs.y,qs.x,0];return!z0(n,ya,xa,_a,Ff)||(n=[1,0,0,0,1,0,0,0,1],!z0(n,ya,xa,_a,Ff))?!1:(Of.crossVectors(jr,Qr),n=[Of.x,Of.y,Of.z],z0(n,ya,xa,_a,Ff))}clampPoint(t,n){return n.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,pi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(pi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(pr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),pr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),pr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),pr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),pr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),pr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),pr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),pr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(pr),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}},pr=[new Y,new Y,new Y,new Y,new Y,new Y,new Y,new Y],pi=new Y,Uf=new ao,ya=new Y,xa=new Y,_a=new Y,jr=new Y,Qr=new Y,qs=new Y,rl=new Y,Ff=new Y,Of=new Y,Zs=new Y;function z0(e,t,n,i,r){for(let s=0,o=e.length-3;s<=o;s+=3){Zs.fromArray(e,s);let a=r.x*Math.abs(Zs.x)+r.y*Math.abs(Zs.y)+r.z*Math.abs(Zs.z),c=t.dot(Zs),l=n.dot(Zs),u=i.dot(Zs);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>a)return!1}return!0}var T4=new ao,sl=new Y,V0=new Y,co=class{constructor(t=new Y,n=-1){this.isSphere=!0,this.center=t,this.radius=n}set(t,n){return this.center.copy(t),this.radius=n,this}setFromPoints(t,n){let i=this.center;n!==void 0?i.copy(n):T4.setFromPoints(t).getCenter(i);let r=0;for(let s=0,o=t.length;s<o;s++)r=Math.max(r,i.distanceToSquared(t[s]));return this.radius=Math.sqrt(r),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let n=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=n*n}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,n){let i=this.center.distanceToSquared(t);return n.copy(t),i>this.radius*this.radius&&(n.sub(this.center).normalize(),n.multiplyScalar(this.radius).add(this.center)),n}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;sl.subVectors(t,this.center);let n=sl.lengthSq();if(n>this.radius*this.radius){let i=Math.sqrt(n),r=(i-this.radius)*.5;this.center.addScaledVector(sl,r/i),this.radius+=r}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(V0.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(sl.copy(t.center).add(V0)),this.expandByPoint(sl.copy(t.center).sub(V0))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}},mr=new Y,H0=new Y,Bf=new Y,ts=new Y,G0=new Y,kf=new Y,W0=new Y,dl=class{constructor(t=new Y,n=new Y(0,0,-1)){this.origin=t,this.direction=n}set(t,n){return this.origin.copy(t),this.direction.copy(n),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,n){return n.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,mr)),this}closestPointToPoint(t,n){n.subVectors(t,this.origin);let i=n.dot(this.direction);return i<0?n.copy(this.origin):n.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let n=mr.subVectors(t,this.origin).dot(this.direction);return n<0?this.origin.distanceToSquared(t):(mr.copy(this.origin).addScaledVector(this.direction,n),mr.distanceToSquared(t))}distanceSqToSegment(t,n,i,r){H0.copy(t).add(n).multiplyScalar(.5),Bf.copy(n).sub(t).normalize(),ts.copy(this.origin).sub(H0);let s=t.distanceTo(n)*.5,o=-this.direction.dot(Bf),a=ts.dot(this.direction),c=-ts.dot(Bf),l=ts.lengthSq(),u=Math.abs(1-o*o),h,f,d,m;if(u>0)if(h=o*c-a,f=o*a-c,m=s*u,h>=0)if(f>=-m)if(f<=m){let y=1/u;h*=y,f*=y,d=h*(h+o*f+2*a)+f*(o*h+f+2*c)+l}else f=s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*c)+l;else f=-s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*c)+l;else f<=-m?(h=Math.max(0,-(-o*s+a)),f=h>0?-s:Math.min(Math.max(-s,-c),s),d=-h*h+f*(f+2*c)+l):f<=m?(h=0,f=Math.min(Math.max(-s,-c),s),d=f*(f+2*c)+l):(h=Math.max(0,-(o*s+a)),f=h>0?s:Math.min(Math.max(-s,-c),s),d=-h*h+f*(f+2*c)+l);else f=o>0?-s:s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,h),r&&r.copy(H0).addScaledVector(Bf,f),d}intersectSphere(t,n){mr.subVectors(t.center,this.origin);let i=mr.dot(this.direction),r=mr.dot(mr)-i*i,s=t.radius*t.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,n):this.at(a,n)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let n=t.normal.dot(this.direction);if(n===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/n;return i>=0?i:null}intersectPlane(t,n){let i=this.distanceToPlane(t);return i===null?null:this.at(i,n)}intersectsPlane(t){let n=t.distanceToPoint(this.origin);return n===0||t.normal.dot(this.direction)*n<0}intersectBox(t,n){let i,r,s,o,a,c,l=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return l>=0?(i=(t.min.x-f.x)*l,r=(t.max.x-f.x)*l):(i=(t.max.x-f.x)*l,r=(t.min.x-f.x)*l),u>=0?(s=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(s=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),h>=0?(a=(t.min.z-f.z)*h,c=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,c=(t.min.z-f.z)*h),i>c||a>r)||((a>i||i!==i)&&(i=a),(c<r||r!==r)&&(r=c),r<0)?null:this.at(i>=0?i:r,n)}intersectsBox(t){return this.intersectBox(t,mr)!==null}intersectTriangle(t,n,i,r,s){G0.subVectors(n,t),kf.subVectors(i,t),W0.crossVectors(G0,kf);let o=this.direction.dot(W0),a;if(o>0){if(r)return null;a=1}else if(o<0)a=-1,o=-o;else return null;ts.subVectors(this.origin,t);let c=a*this.direction.dot(kf.crossVectors(ts,kf));if(c<0)return null;let l=a*this.direction.dot(G0.cross(ts));if(l<0||c+l>o)return null;let u=-a*ts.dot(W0);return u<0?null:this.at(u/o,s)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},De=class e{constructor(t,n,i,r,s,o,a,c,l,u,h,f,d,m,y,g){e.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,n,i,r,s,o,a,c,l,u,h,f,d,m,y,g)}set(t,n,i,r,s,o,a,c,l,u,h,f,d,m,y,g){let p=this.elements;return p[0]=t,p[4]=n,p[8]=i,p[12]=r,p[1]=s,p[5]=o,p[9]=a,p[13]=c,p[2]=l,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=m,p[11]=y,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new e().fromArray(this.elements)}copy(t){let n=this.elements,i=t.elements;return n[0]=i[0],n[1]=i[1],n[2]=i[2],n[3]=i[3],n[4]=i[4],n[5]=i[5],n[6]=i[6],n[7]=i[7],n[8]=i[8],n[9]=i[9],n[10]=i[10],n[11]=i[11],n[12]=i[12],n[13]=i[13],n[14]=i[14],n[15]=i[15],this}copyPosition(t){let n=this.elements,i=t.elements;return n[12]=i[12],n[13]=i[13],n[14]=i[14],this}setFromMatrix3(t){let n=t.elements;return this.set(n[0],n[3],n[6],0,n[1],n[4],n[7],0,n[2],n[5],n[8],0,0,0,0,1),this}extractBasis(t,n,i){return t.setFromMatrixColumn(this,0),n.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(t,n,i){return this.set(t.x,n.x,i.x,0,t.y,n.y,i.y,0,t.z,n.z,i.z,0,0,0,0,1),this}extractRotation(t){let n=this.elements,i=t.elements,r=1/va.setFromMatrixColumn(t,0).length(),s=1/va.setFromMatrixColumn(t,1).length(),o=1/va.setFromMatrixColumn(t,2).length();return n[0]=i[0]*r,n[1]=i[1]*r,n[2]=i[2]*r,n[3]=0,n[4]=i[4]*s,n[5]=i[5]*s,n[6]=i[6]*s,n[7]=0,n[8]=i[8]*o,n[9]=i[9]*o,n[10]=i[10]*o,n[11]=0,n[12]=0,n[13]=0,n[14]=0,n[15]=1,this}makeRotationFromEuler(t){let n=this.elements,i=t.x,r=t.y,s=t.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(r),l=Math.sin(r),u=Math.cos(s),h=Math.sin(s);if(t.order==="XYZ"){let f=o*u,d=o*h,m=a*u,y=a*h;n[0]=c*u,n[4]=-c*h,n[8]=l,n[1]=d+m*l,n[5]=f-y*l,n[9]=-a*c,n[2]=y-f*l,n[6]=m+d*l,n[10]=o*c}else if(t.order==="YXZ"){let f=c*u,d=c*h,m=l*u,y=l*h;n[0]=f+y*a,n[4]=m*a-d,n[8]=o*l,n[1]=o*h,n[5]=o*u,n[9]=-a,n[2]=d*a-m,n[6]=y+f*a,n[10]=o*c}else if(t.order==="ZXY"){let f=c*u,d=c*h,m=l*u,y=l*h;n[0]=f-y*a,n[4]=-o*h,n[8]=m+d*a,n[1]=d+m*a,n[5]=o*u,n[9]=y-f*a,n[2]=-o*l,n[6]=a,n[10]=o*c}else if(t.order==="ZYX"){let f=o*u,d=o*h,m=a*u,y=a*h;n[0]=c*u,n[4]=m*l-d,n[8]=f*l+y,n[1]=c*h,n[5]=y*l+f,n[9]=d*l-m,n[2]=-l,n[6]=a*c,n[10]=o*c}else if(t.order==="YZX"){let f=o*c,d=o*l,m=a*c,y=a*l;n[0]=c*u,n[4]=y-f*h,n[8]=m*h+d,n[1]=h,n[5]=o*u,n[9]=-a*u,n[2]=-l*u,n[6]=d*h+m,n[10]=f-y*h}else if(t.order==="XZY"){let f=o*c,d=o*l,m=a*c,y=a*l;n[0]=c*u,n[4]=-h,n[8]=l*u,n[1]=f*h+y,n[5]=o*u,n[9]=d*h-m,n[2]=m*h-d,n[6]=a*u,n[10]=y*h+f}return n[3]=0,n[7]=0,n[11]=0,n[12]=0,n[13]=0,n[14]=0,n[15]=1,this}makeRotationFromQuaternion(t){return this.compose(E4,t,A4)}lookAt(t,n,i){let r=this.elements;return Rn.subVectors(t,n),Rn.lengthSq()===0&&(Rn.z=1),Rn.normalize(),es.crossVectors(i,Rn),es.lengthSq()===0&&(Math.abs(i.z)===1?Rn.x+=1e-4:Rn.z+=1e-4,Rn.normalize(),es.crossVectors(i,Rn)),es.normalize(),zf.crossVectors(Rn,es),r[0]=es.x,r[4]=zf.x,r[8]=Rn.x,r[1]=es.y,r[5]=zf.y,r[9]=Rn.y,r[2]=es.z,r[6]=zf.z,r[10]=Rn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,n){let i=t.elements,r=n.elements,s=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],u=i[1],h=i[5],f=i[9],d=i[13],m=i[2],y=i[6],g=i[10],p=i[14],_=i[3],b=i[7],x=i[11],C=i[15],w=r[0],S=r[4],R=r[8],M=r[12],v=r[1],E=r[5],N=r[9],U=r[13],F=r[2],P=r[6],O=r[10],H=r[14],z=r[3],G=r[7],j=r[11],nt=r[15];return s[0]=o*w+a*v+c*F+l*z,s[4]=o*S+a*E+c*P+l*G,s[8]=o*R+a*N+c*O+l*j,s[12]=o*M+a*U+c*H+l*nt,s[1]=u*w+h*v+f*F+d*z,s[5]=u*S+h*E+f*P+d*G,s[9]=u*R+h*N+f*O+d*j,s[13]=u*M+h*U+f*H+d*nt,s[2]=m*w+y*v+g*F+p*z,s[6]=m*S+y*E+g*P+p*G,s[10]=m*R+y*N+g*O+p*j,s[14]=m*M+y*U+g*H+p*nt,s[3]=_*w+b*v+x*F+C*z,s[7]=_*S+b*E+x*P+C*G,s[11]=_*R+b*N+x*O+C*j,s[15]=_*M+b*U+x*H+C*nt,this}multiplyScalar(t){let n=this.elements;return n[0]*=t,n[4]*=t,n[8]*=t,n[12]*=t,n[1]*=t,n[5]*=t,n[9]*=t,n[13]*=t,n[2]*=t,n[6]*=t,n[10]*=t,n[14]*=t,n[3]*=t,n[7]*=t,n[11]*=t,n[15]*=t,this}determinant(){let t=this.elements,n=t[0],i=t[4],r=t[8],s=t[12],o=t[1],a=t[5],c=t[9],l=t[13],u=t[2],h=t[6],f=t[10],d=t[14],m=t[3],y=t[7],g=t[11],p=t[15];return m*(+s*c*h-r*l*h-s*a*f+i*l*f+r*a*d-i*c*d)+y*(+n*c*d-n*l*f+s*o*f-r*o*d+r*l*u-s*c*u)+g*(+n*l*h-n*a*d-s*o*h+i*o*d+s*a*u-i*l*u)+p*(-r*a*u-n*c*h+n*a*f+r*o*h-i*o*f+i*c*u)}transpose(){let t=this.elements,n;return n=t[1],t[1]=t[4],t[4]=n,n=t[2],t[2]=t[8],t[8]=n,n=t[6],t[6]=t[9],t[9]=n,n=t[3],t[3]=t[12],t[12]=n,n=t[7],t[7]=t[13],t[13]=n,n=t[11],t[11]=t[14],t[14]=n,this}setPosition(t,n,i){let r=this.elements;return t.isVector3?(r[12]=t.x,r[13]=t.y,r[14]=t.z):(r[12]=t,r[13]=n,r[14]=i),this}invert(){let t=this.elements,n=t[0],i=t[1],r=t[2],s=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],h=t[9],f=t[10],d=t[11],m=t[12],y=t[13],g=t[14],p=t[15],_=h*g*l-y*f*l+y*c*d-a*g*d-h*c*p+a*f*p,b=m*f*l-u*g*l-m*c*d+o*g*d+u*c*p-o*f*p,x=u*y*l-m*h*l+m*a*d-o*y*d-u*a*p+o*h*p,C=m*h*c-u*y*c-m*a*f+o*y*f+u*a*g-o*h*g,w=n*_+i*b+r*x+s*C;if(w===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let S=1/w;return t[0]=_*S,t[1]=(y*f*s-h*g*s-y*r*d+i*g*d+h*r*p-i*f*p)*S,t[2]=(a*g*s-y*c*s+y*r*l-i*g*l-a*r*p+i*c*p)*S,t[3]=(h*c*s-a*f*s-h*r*l+i*f*l+a*r*d-i*c*d)*S,t[4]=b*S,t[5]=(u*g*s-m*f*s+m*r*d-n*g*d-u*r*p+n*f*p)*S,t[6]=(m*c*s-o*g*s-m*r*l+n*g*l+o*r*p-n*c*p)*S,t[7]=(o*f*s-u*c*s+u*r*l-n*f*l-o*r*d+n*c*d)*S,t[8]=x*S,t[9]=(m*h*s-u*y*s-m*i*d+n*y*d+u*i*p-n*h*p)*S,t[10]=(o*y*s-m*a*s+m*i*l-n*y*l-o*i*p+n*a*p)*S,t[11]=(u*a*s-o*h*s-u*i*l+n*h*l+o*i*d-n*a*d)*S,t[12]=C*S,t[13]=(u*y*r-m*h*r+m*i*f-n*y*f-u*i*g+n*h*g)*S,t[14]=(m*a*r-o*y*r-m*i*c+n*y*c+o*i*g-n*a*g)*S,t[15]=(o*h*r-u*a*r+u*i*c-n*h*c-o*i*f+n*a*f)*S,this}scale(t){let n=this.elements,i=t.x,r=t.y,s=t.z;return n[0]*=i,n[4]*=r,n[8]*=s,n[1]*=i,n[5]*=r,n[9]*=s,n[2]*=i,n[6]*=r,n[10]*=s,n[3]*=i,n[7]*=r,n[11]*=s,this}getMaxScaleOnAxis(){let t=this.elements,n=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],r=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(n,i,r))}makeTranslation(t,n,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,n,0,0,1,i,0,0,0,1),this}makeRotationX(t){let n=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,n,-i,0,0,i,n,0,0,0,0,1),this}makeRotationY(t){let n=Math.cos(t),i=Math.sin(t);return this.set(n,0,i,0,0,1,0,0,-i,0,n,0,0,0,0,1),this}makeRotationZ(t){let n=Math.cos(t),i=Math.sin(t);return this.set(n,-i,0,0,i,n,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,n){let i=Math.cos(n),r=Math.sin(n),s=1-i,o=t.x,a=t.y,c=t.z,l=s*o,u=s*a;return this.set(l*o+i,l*a-r*c,l*c+r*a,0,l*a+r*c,u*a+i,u*c-r*o,0,l*c-r*a,u*c+r*o,s*c*c+i,0,0,0,0,1),this}makeScale(t,n,i){return this.set(t,0,0,0,0,n,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,n,i,r,s,o){return this.set(1,i,s,0,t,1,o,0,n,r,1,0,0,0,0,1),this}compose(t,n,i){let r=this.elements,s=n._x,o=n._y,a=n._z,c=n._w,l=s+s,u=o+o,h=a+a,f=s*l,d=s*u,m=s*h,y=o*u,g=o*h,p=a*h,_=c*l,b=c*u,x=c*h,C=i.x,w=i.y,S=i.z;return r[0]=(1-(y+p))*C,r[1]=(d+x)*C,r[2]=(m-b)*C,r[3]=0,r[4]=(d-x)*w,r[5]=(1-(f+p))*w,r[6]=(g+_)*w,r[7]=0,r[8]=(m+b)*S,r[9]=(g-_)*S,r[10]=(1-(f+y))*S,r[11]=0,r[12]=t.x,r[13]=t.y,r[14]=t.z,r[15]=1,this}decompose(t,n,i){let r=this.elements,s=va.set(r[0],r[1],r[2]).length(),o=va.set(r[4],r[5],r[6]).length(),a=va.set(r[8],r[9],r[10]).length();this.determinant()<0&&(s=-s),t.x=r[12],t.y=r[13],t.z=r[14],mi.copy(this);let l=1/s,u=1/o,h=1/a;return mi.elements[0]*=l,mi.elements[1]*=l,mi.elements[2]*=l,mi.elements[4]*=u,mi.elements[5]*=u,mi.elements[6]*=u,mi.elements[8]*=h,mi.elements[9]*=h,mi.elements[10]*=h,n.setFromRotationMatrix(mi),i.x=s,i.y=o,i.z=a,this}makePerspective(t,n,i,r,s,o,a=wr){let c=this.elements,l=2*s/(n-t),u=2*s/(i-r),h=(n+t)/(n-t),f=(i+r)/(i-r),d,m;if(a===wr)d=-(o+s)/(o-s),m=-2*o*s/(o-s);else if(a===dh)d=-o/(o-s),m=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=l,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=d,c[14]=m,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,n,i,r,s,o,a=wr){let c=this.elements,l=1/(n-t),u=1/(i-r),h=1/(o-s),f=(n+t)*l,d=(i+r)*u,m,y;if(a===wr)m=(o+s)*h,y=-2*h;else if(a===dh)m=s*h,y=-1*h;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=2*l,c[4]=0,c[8]=0,c[12]=-f,c[1]=0,c[5]=2*u,c[9]=0,c[13]=-d,c[2]=0,c[6]=0,c[10]=y,c[14]=-m,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let n=this.elements,i=t.elements;for(let r=0;r<16;r++)if(n[r]!==i[r])return!1;return!0}fromArray(t,n=0){for(let i=0;i<16;i++)this.elements[i]=t[i+n];return this}toArray(t=[],n=0){let i=this.elements;return t[n]=i[0],t[n+1]=i[1],t[n+2]=i[2],t[n+3]=i[3],t[n+4]=i[4],t[n+5]=i[5],t[n+6]=i[6],t[n+7]=i[7],t[n+8]=i[8],t[n+9]=i[9],t[n+10]=i[10],t[n+11]=i[11],t[n+12]=i[12],t[n+13]=i[13],t[n+14]=i[14],t[n+15]=i[15],t}},va=new Y,mi=new De,E4=new Y(0,0,0),A4=new Y(1,1,1),es=new Y,zf=new Y,Rn=new Y,FT=new De,OT=new us,Ar=class e{constructor(t=0,n=0,i=0,r=e.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=n,this._z=i,this._order=r}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,n,i,r=this._order){return this._x=t,this._y=n,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,n=this._order,i=!0){let r=t.elements,s=r[0],o=r[4],a=r[8],c=r[1],l=r[5],u=r[9],h=r[2],f=r[6],d=r[10];switch(n){case"XYZ":this._y=Math.asin(bn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(f,l),this._z=0);break;case"YXZ":this._x=Math.asin(-bn(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-h,s),this._z=0);break;case"ZXY":this._x=Math.asin(bn(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,s));break;case"ZYX":this._y=Math.asin(-bn(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(c,s)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(bn(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-h,s)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-bn(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,l),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-u,d),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+n)}return this._order=n,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,n,i){return FT.makeRotationFromQuaternion(t),this.setFromRotationMatrix(FT,n,i)}setFromVector3(t,n=this._order){return this.set(t.x,t.y,t.z,n)}reorder(t){return OT.setFromEuler(this),this.setFromQuaternion(OT,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],n=0){return t[n]=this._x,t[n+1]=this._y,t[n+2]=this._z,t[n+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ar.DEFAULT_ORDER="XYZ";var yh=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},C4=0,BT=new Y,ba=new us,gr=new De,Vf=new Y,ol=new Y,R4=new Y,I4=new us,kT=new Y(1,0,0),zT=new Y(0,1,0),VT=new Y(0,0,1),HT={type:"added"},P4={type:"removed"},Ma={type:"childadded",child:null},$0={type:"childremoved",child:null},Dn=class e extends ls{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:C4++}),this.uuid=yl(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=e.DEFAULT_UP.clone();let t=new Y,n=new Ar,i=new us,r=new Y(1,1,1);function s(){i.setFromEuler(n,!1)}function o(){n.setFromQuaternion(i,void 0,!1)}n._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:n},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new De},normalMatrix:{value:new Wt}}),this.matrix=new De,this.matrixWorld=new De,this.matrixAutoUpdate=e.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=e.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new yh,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,n){this.quaternion.setFromAxisAngle(t,n)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,n){return ba.setFromAxisAngle(t,n),this.quaternion.multiply(ba),this}rotateOnWorldAxis(t,n){return ba.setFromAxisAngle(t,n),this.quaternion.premultiply(ba),this}rotateX(t){return this.rotateOnAxis(kT,t)}rotateY(t){return this.rotateOnAxis(zT,t)}rotateZ(t){return this.rotateOnAxis(VT,t)}translateOnAxis(t,n){return BT.copy(t).applyQuaternion(this.quaternion),this.position.add(BT.multiplyScalar(n)),this}translateX(t){return this.translateOnAxis(kT,t)}translateY(t){return this.translateOnAxis(zT,t)}translateZ(t){return this.translateOnAxis(VT,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(gr.copy(this.matrixWorld).invert())}lookAt(t,n,i){t.isVector3?Vf.copy(t):Vf.set(t,n,i);let r=this.parent;this.updateWorldMatrix(!0,!1),ol.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?gr.lookAt(ol,Vf,this.up):gr.lookAt(Vf,ol,this.up),this.quaternion.setFromRotationMatrix(gr),r&&(gr.extractRotation(r.matrixWorld),ba.setFromRotationMatrix(gr),this.quaternion.premultiply(ba.invert()))}add(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.add(arguments[n]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(HT),Ma.child=t,this.dispatchEvent(Ma),Ma.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let n=this.children.indexOf(t);return n!==-1&&(t.parent=null,this.children.splice(n,1),t.dispatchEvent(P4),$0.child=t,this.dispatchEvent($0),$0.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),gr.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),gr.multiply(t.parent.matrixWorld)),t.applyMatrix4(gr),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(HT),Ma.child=t,this.dispatchEvent(Ma),Ma.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,n){if(this[t]===n)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(t,n);if(o!==void 0)return o}}getObjectsByProperty(t,n,i=[]){this[t]===n&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(t,n,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ol,t,R4),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ol,I4,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let n=this.matrixWorld.elements;return t.set(n[8],n[9],n[10]).normalize()}raycast(){}traverse(t){t(this);let n=this.children;for(let i=0,r=n.length;i<r;i++)n[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let n=this.children;for(let i=0,r=n.length;i<r;i++)n[i].traverseVisible(t)}traverseAncestors(t){let n=this.parent;n!==null&&(t(n),n.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let n=this.children;for(let i=0,r=n.length;i<r;i++)n[i].updateMatrixWorld(t)}updateWorldMatrix(t,n){let i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),n===!0){let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].updateWorldMatrix(!1,!0)}}toJSON(t){let n=t===void 0||typeof t=="string",i={};n&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,this.name!==""&&(r.name=this.name),this.castShadow===!0&&(r.castShadow=!0),this.receiveShadow===!0&&(r.receiveShadow=!0),this.visible===!1&&(r.visible=!1),this.frustumCulled===!1&&(r.frustumCulled=!1),this.renderOrder!==0&&(r.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(r.matrixAutoUpdate=!1),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.visibility=this._visibility,r.active=this._active,r.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.geometryCount=this._geometryCount,r.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(r.boundingSphere={center:r.boundingSphere.center.toArray(),radius:r.boundingSphere.radius}),this.boundingBox!==null&&(r.boundingBox={min:r.boundingBox.min.toArray(),max:r.boundingBox.max.toArray()}));function s(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){let h=c[l];s(t.shapes,h)}else s(t.shapes,c)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(t.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(s(t.materials,this.material[c]));r.material=a}else r.material=s(t.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];r.animations.push(s(t.animations,c))}}if(n){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),m=o(t.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),m.length>0&&(i.nodes=m)}return i.object=r,i;function o(a){let c=[];for(let l in a){let u=a[l];delete u.metadata,c.push(u)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,n=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),n===!0)for(let i=0;i<t.children.length;i++){let r=t.children[i];this.add(r.clone())}return this}};Dn.DEFAULT_UP=new Y(0,1,0);Dn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Dn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var gi=new Y,yr=new Y,X0=new Y,xr=new Y,wa=new Y,Sa=new Y,GT=new Y,Y0=new Y,q0=new Y,Z0=new Y,J0=new Ne,K0=new Ne,j0=new Ne,no=class e{constructor(t=new Y,n=new Y,i=new Y){this.a=t,this.b=n,this.c=i}static getNormal(t,n,i,r){r.subVectors(i,n),gi.subVectors(t,n),r.cross(gi);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(t,n,i,r,s){gi.subVectors(r,n),yr.subVectors(i,n),X0.subVectors(t,n);let o=gi.dot(gi),a=gi.dot(yr),c=gi.dot(X0),l=yr.dot(yr),u=yr.dot(X0),h=o*l-a*a;if(h===0)return s.set(0,0,0),null;let f=1/h,d=(l*c-a*u)*f,m=(o*u-a*c)*f;return s.set(1-d-m,m,d)}static containsPoint(t,n,i,r){return this.getBarycoord(t,n,i,r,xr)===null?!1:xr.x>=0&&xr.y>=0&&xr.x+xr.y<=1}static getInterpolation(t,n,i,r,s,o,a,c){return this.getBarycoord(t,n,i,r,xr)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(s,xr.x),c.addScaledVector(o,xr.y),c.addScaledVector(a,xr.z),c)}static getInterpolatedAttribute(t,n,i,r,s,o){return J0.setScalar(0),K0.setScalar(0),j0.setScalar(0),J0.fromBufferAttribute(t,n),K0.fromBufferAttribute(t,i),j0.fromBufferAttribute(t,r),o.setScalar(0),o.addScaledVector(J0,s.x),o.addScaledVector(K0,s.y),o.addScaledVector(j0,s.z),o}static isFrontFacing(t,n,i,r){return gi.subVectors(i,n),yr.subVectors(t,n),gi.cross(yr).dot(r)<0}set(t,n,i){return this.a.copy(t),this.b.copy(n),this.c.copy(i),this}setFromPointsAndIndices(t,n,i,r){return this.a.copy(t[n]),this.b.copy(t[i]),this.c.copy(t[r]),this}setFromAttributeAndIndices(t,n,i,r){return this.a.fromBufferAttribute(t,n),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,r),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return gi.subVectors(this.c,this.b),yr.subVectors(this.a,this.b),gi.cross(yr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return e.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,n){return e.getBarycoord(t,this.a,this.b,this.c,n)}getInterpolation(t,n,i,r,s){return e.getInterpolation(t,this.a,this.b,this.c,n,i,r,s)}containsPoint(t){return e.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return e.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,n){let i=this.a,r=this.b,s=this.c,o,a;wa.subVectors(r,i),Sa.subVectors(s,i),Y0.subVectors(t,i);let c=wa.dot(Y0),l=Sa.dot(Y0);if(c<=0&&l<=0)return n.copy(i);q0.subVectors(t,r);let u=wa.dot(q0),h=Sa.dot(q0);if(u>=0&&h<=u)return n.copy(r);let f=c*h-u*l;if(f<=0&&c>=0&&u<=0)return o=c/(c-u),n.copy(i).addScaledVector(wa,o);Z0.subVectors(t,s);let d=wa.dot(Z0),m=Sa.dot(Z0);if(m>=0&&d<=m)return n.copy(s);let y=d*l-c*m;if(y<=0&&l>=0&&m<=0)return a=l/(l-m),n.copy(i).addScaledVector(Sa,a);let g=u*m-d*h;if(g<=0&&h-u>=0&&d-m>=0)return GT.subVectors(s,r),a=(h-u)/(h-u+(d-m)),n.copy(r).addScaledVector(GT,a);let p=1/(g+y+f);return o=y*p,a=f*p,n.copy(i).addScaledVector(wa,o).addScaledVector(Sa,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},zE={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ns={h:0,s:0,l:0},Hf={h:0,s:0,l:0};function Q0(e,t,n){return n<0&&(n+=1),n>1&&(n-=1),n<1/6?e+(t-e)*6*n:n<1/2?t:n<2/3?e+(t-e)*6*(2/3-n):e}var Kt=class{constructor(t,n,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,n,i)}set(t,n,i){if(n===void 0&&i===void 0){let r=t;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(t,n,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,n=ti){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ee.toWorkingColorSpace(this,n),this}setRGB(t,n,i,r=ee.workingColorSpace){return this.r=t,this.g=n,this.b=i,ee.toWorkingColorSpace(this,r),this}setHSL(t,n,i,r=ee.workingColorSpace){if(t=x4(t,1),n=bn(n,0,1),i=bn(i,0,1),n===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+n):i+n-i*n,o=2*i-s;this.r=Q0(o,s,t+1/3),this.g=Q0(o,s,t),this.b=Q0(o,s,t-1/3)}return ee.toWorkingColorSpace(this,r),this}setStyle(t,n=ti){function i(s){s!==void 0&&parseFloat(s)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(t)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,n);if(s=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseInt(s[1],10))/100,Math.min(100,parseInt(s[2],10))/100,Math.min(100,parseInt(s[3],10))/100,n);break;case"hsl":case"hsla":if(s=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,n);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(t)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,n);if(o===6)return this.setHex(parseInt(s,16),n);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,n);return this}setColorName(t,n=ti){let i=zE[t.toLowerCase()];return i!==void 0?this.setHex(i,n):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Sr(t.r),this.g=Sr(t.g),this.b=Sr(t.b),this}copyLinearToSRGB(t){return this.r=La(t.r),this.g=La(t.g),this.b=La(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ti){return ee.fromWorkingColorSpace(rn.copy(this),t),Math.round(bn(rn.r*255,0,255))*65536+Math.round(bn(rn.g*255,0,255))*256+Math.round(bn(rn.b*255,0,255))}getHexString(t=ti){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,n=ee.workingColorSpace){ee.fromWorkingColorSpace(rn.copy(this),n);let i=rn.r,r=rn.g,s=rn.b,o=Math.max(i,r,s),a=Math.min(i,r,s),c,l,u=(a+o)/2;if(a===o)c=0,l=0;else{let h=o-a;switch(l=u<=.5?h/(o+a):h/(2-o-a),o){case i:c=(r-s)/h+(r<s?6:0);break;case r:c=(s-i)/h+2;break;case s:c=(i-r)/h+4;break}c/=6}return t.h=c,t.s=l,t.l=u,t}getRGB(t,n=ee.workingColorSpace){return ee.fromWorkingColorSpace(rn.copy(this),n),t.r=rn.r,t.g=rn.g,t.b=rn.b,t}getStyle(t=ti){ee.fromWorkingColorSpace(rn.copy(this),t);let n=rn.r,i=rn.g,r=rn.b;return t!==ti?`color(${t} ${n.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(n*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(t,n,i){return this.getHSL(ns),this.setHSL(ns.h+t,ns.s+n,ns.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,n){return this.r=t.r+n.r,this.g=t.g+n.g,this.b=t.b+n.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,n){return this.r+=(t.r-this.r)*n,this.g+=(t.g-this.g)*n,this.b+=(t.b-this.b)*n,this}lerpColors(t,n,i){return this.r=t.r+(n.r-t.r)*i,this.g=t.g+(n.g-t.g)*i,this.b=t.b+(n.b-t.b)*i,this}lerpHSL(t,n){this.getHSL(ns),t.getHSL(Hf);let i=F0(ns.h,Hf.h,n),r=F0(ns.s,Hf.s,n),s=F0(ns.l,Hf.l,n);return this.setHSL(i,r,s),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let n=this.r,i=this.g,r=this.b,s=t.elements;return this.r=s[0]*n+s[3]*i+s[6]*r,this.g=s[1]*n+s[4]*i+s[7]*r,this.b=s[2]*n+s[5]*i+s[8]*r,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,n=0){return this.r=t[n],this.g=t[n+1],this.b=t[n+2],this}toArray(t=[],n=0){return t[n]=this.r,t[n+1]=this.g,t[n+2]=this.b,t}fromBufferAttribute(t,n){return this.r=t.getX(n),this.g=t.getY(n),this.b=t.getZ(n),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},rn=new Kt;Kt.NAMES=zE;var L4=0,fs=class extends ls{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:L4++}),this.uuid=yl(),this.name="",this.blending=Ia,this.side=cs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=uy,this.blendDst=fy,this.blendEquation=eo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Kt(0,0,0),this.blendAlpha=0,this.depthFunc=Da,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=AT,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ma,this.stencilZFail=ma,this.stencilZPass=ma,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let n in t){let i=t[n];if(i===void 0){console.warn(`THREE.Material: parameter '${n}' has value of undefined.`);continue}let r=this[n];if(r===void 0){console.warn(`THREE.Material: '${n}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[n]=i}}toJSON(t){let n=t===void 0||typeof t=="string";n&&(t={textures:{},images:{}});let i={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Ia&&(i.blending=this.blending),this.side!==cs&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==uy&&(i.blendSrc=this.blendSrc),this.blendDst!==fy&&(i.blendDst=this.blendDst),this.blendEquation!==eo&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==Da&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==AT&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==ma&&(i.stencilFail=this.stencilFail),this.stencilZFail!==ma&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==ma&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let c=s[a];delete c.metadata,o.push(c)}return o}if(n){let s=r(t.textures),o=r(t.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let n=t.clippingPlanes,i=null;if(n!==null){let r=n.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=n[s].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}},xh=class extends fs{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new Kt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ar,this.combine=EE,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}};var Ue=new Y,Gf=new le,Ze=class{constructor(t,n,i=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=n,this.count=t!==void 0?t.length/n:0,this.normalized=i,this.usage=CT,this.updateRanges=[],this.gpuType=Mr,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,n){this.updateRanges.push({start:t,count:n})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,n,i){t*=this.itemSize,i*=n.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[t+r]=n.array[i+r];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let n=0,i=this.count;n<i;n++)Gf.fromBufferAttribute(this,n),Gf.applyMatrix3(t),this.setXY(n,Gf.x,Gf.y);else if(this.itemSize===3)for(let n=0,i=this.count;n<i;n++)Ue.fromBufferAttribute(this,n),Ue.applyMatrix3(t),this.setXYZ(n,Ue.x,Ue.y,Ue.z);return this}applyMatrix4(t){for(let n=0,i=this.count;n<i;n++)Ue.fromBufferAttribute(this,n),Ue.applyMatrix4(t),this.setXYZ(n,Ue.x,Ue.y,Ue.z);return this}applyNormalMatrix(t){for(let n=0,i=this.count;n<i;n++)Ue.fromBufferAttribute(this,n),Ue.applyNormalMatrix(t),this.setXYZ(n,Ue.x,Ue.y,Ue.z);return this}transformDirection(t){for(let n=0,i=this.count;n<i;n++)Ue.fromBufferAttribute(this,n),Ue.transformDirection(t),this.setXYZ(n,Ue.x,Ue.y,Ue.z);return this}set(t,n=0){return this.array.set(t,n),this}getComponent(t,n){let i=this.array[t*this.itemSize+n];return this.normalized&&(i=il(i,this.array)),i}setComponent(t,n,i){return this.normalized&&(i=vn(i,this.array)),this.array[t*this.itemSize+n]=i,this}getX(t){let n=this.array[t*this.itemSize];return this.normalized&&(n=il(n,this.array)),n}setX(t,n){return this.normalized&&(n=vn(n,this.array)),this.array[t*this.itemSize]=n,this}getY(t){let n=this.array[t*this.itemSize+1];return this.normalized&&(n=il(n,this.array)),n}setY(t,n){return this.normalized&&(n=vn(n,this.array)),this.array[t*this.itemSize+1]=n,this}getZ(t){let n=this.array[t*this.itemSize+2];return this.normalized&&(n=il(n,this.array)),n}setZ(t,n){return this.normalized&&(n=vn(n,this.array)),this.array[t*this.itemSize+2]=n,this}getW(t){let n=this.array[t*this.itemSize+3];return this.normalized&&(n=il(n,this.array)),n}setW(t,n){return this.normalized&&(n=vn(n,this.array)),this.array[t*this.itemSize+3]=n,this}setXY(t,n,i){return t*=this.itemSize,this.normalized&&(n=vn(n,this.array),i=vn(i,this.array)),this.array[t+0]=n,this.array[t+1]=i,this}setXYZ(t,n,i,r){return t*=this.itemSize,this.normalized&&(n=vn(n,this.array),i=vn(i,this.array),r=vn(r,this.array)),this.array[t+0]=n,this.array[t+1]=i,this.array[t+2]=r,this}setXYZW(t,n,i,r,s){return t*=this.itemSize,this.normalized&&(n=vn(n,this.array),i=vn(i,this.array),r=vn(r,this.array),s=vn(s,this.array)),this.array[t+0]=n,this.array[t+1]=i,this.array[t+2]=r,this.array[t+3]=s,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==CT&&(t.usage=this.usage),t}};var _h=class extends Ze{constructor(t,n,i){super(new Uint8Array(t),n,i)}};var vh=class extends Ze{constructor(t,n,i){super(new Uint16Array(t),n,i)}};var bh=class extends Ze{constructor(t,n,i){super(new Uint32Array(t),n,i)}};var xi=class extends Ze{constructor(t,n,i){super(new Float32Array(t),n,i)}},N4=0,Qn=new De,ty=new Dn,Ta=new Y,In=new ao,al=new ao,qe=new Y,wn=class e extends ls{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:N4++}),this.uuid=yl(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(kE(t)?bh:vh)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,n){return this.attributes[t]=n,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,n,i=0){this.groups.push({start:t,count:n,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,n){this.drawRange.start=t,this.drawRange.count=n}applyMatrix4(t){let n=this.attributes.position;n!==void 0&&(n.applyMatrix4(t),n.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new Wt().getNormalMatrix(t);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(t),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return Qn.makeRotationFromQuaternion(t),this.applyMatrix4(Qn),this}rotateX(t){return Qn.makeRotationX(t),this.applyMatrix4(Qn),this}rotateY(t){return Qn.makeRotationY(t),this.applyMatrix4(Qn),this}rotateZ(t){return Qn.makeRotationZ(t),this.applyMatrix4(Qn),this}translate(t,n,i){return Qn.makeTranslation(t,n,i),this.applyMatrix4(Qn),this}scale(t,n,i){return Qn.makeScale(t,n,i),this.applyMatrix4(Qn),this}lookAt(t){return ty.lookAt(t),ty.updateMatrix(),this.applyMatrix4(ty.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ta).negate(),this.translate(Ta.x,Ta.y,Ta.z),this}setFromPoints(t){let n=this.getAttribute("position");if(n===void 0){let i=[];for(let r=0,s=t.length;r<s;r++){let o=t[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new xi(i,3))}else{for(let i=0,r=n.count;i<r;i++){let s=t[i];n.setXYZ(i,s.x,s.y,s.z||0)}t.length>n.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),n.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ao);let t=this.attributes.position,n=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Y(-1/0,-1/0,-1/0),new Y(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),n)for(let i=0,r=n.length;i<r;i++){let s=n[i];In.setFromBufferAttribute(s),this.morphTargetsRelative?(qe.addVectors(this.boundingBox.min,In.min),this.boundingBox.expandByPoint(qe),qe.addVectors(this.boundingBox.max,In.max),this.boundingBox.expandByPoint(qe)):(this.boundingBox.expandByPoint(In.min),this.boundingBox.expandByPoint(In.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new co);let t=this.attributes.position,n=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Y,1/0);return}if(t){let i=this.boundingSphere.center;if(In.setFromBufferAttribute(t),n)for(let s=0,o=n.length;s<o;s++){let a=n[s];al.setFromBufferAttribute(a),this.morphTargetsRelative?(qe.addVectors(In.min,al.min),In.expandByPoint(qe),qe.addVectors(In.max,al.max),In.expandByPoint(qe)):(In.expandByPoint(al.min),In.expandByPoint(al.max))}In.getCenter(i);let r=0;for(let s=0,o=t.count;s<o;s++)qe.fromBufferAttribute(t,s),r=Math.max(r,i.distanceToSquared(qe));if(n)for(let s=0,o=n.length;s<o;s++){let a=n[s],c=this.morphTargetsRelative;for(let l=0,u=a.count;l<u;l++)qe.fromBufferAttribute(a,l),c&&(Ta.fromBufferAttribute(t,l),qe.add(Ta)),r=Math.max(r,i.distanceToSquared(qe))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,n=this.attributes;if(t===null||n.position===void 0||n.normal===void 0||n.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=n.position,r=n.normal,s=n.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Ze(new Float32Array(4*i.count),4));let o=this.getAttribute("tangent"),a=[],c=[];for(let R=0;R<i.count;R++)a[R]=new Y,c[R]=new Y;let l=new Y,u=new Y,h=new Y,f=new le,d=new le,m=new le,y=new Y,g=new Y;function p(R,M,v){l.fromBufferAttribute(i,R),u.fromBufferAttribute(i,M),h.fromBufferAttribute(i,v),f.fromBufferAttribute(s,R),d.fromBufferAttribute(s,M),m.fromBufferAttribute(s,v),u.sub(l),h.sub(l),d.sub(f),m.sub(f);let E=1/(d.x*m.y-m.x*d.y);isFinite(E)&&(y.copy(u).multiplyScalar(m.y).addScaledVector(h,-d.y).multiplyScalar(E),g.copy(h).multiplyScalar(d.x).addScaledVector(u,-m.x).multiplyScalar(E),a[R].add(y),a[M].add(y),a[v].add(y),c[R].add(g),c[M].add(g),c[v].add(g))}let _=this.groups;_.length===0&&(_=[{start:0,count:t.count}]);for(let R=0,M=_.length;R<M;++R){let v=_[R],E=v.start,N=v.count;for(let U=E,F=E+N;U<F;U+=3)p(t.getX(U+0),t.getX(U+1),t.getX(U+2))}let b=new Y,x=new Y,C=new Y,w=new Y;function S(R){C.fromBufferAttribute(r,R),w.copy(C);let M=a[R];b.copy(M),b.sub(C.multiplyScalar(C.dot(M))).normalize(),x.crossVectors(w,M);let E=x.dot(c[R])<0?-1:1;o.setXYZW(R,b.x,b.y,b.z,E)}for(let R=0,M=_.length;R<M;++R){let v=_[R],E=v.start,N=v.count;for(let U=E,F=E+N;U<F;U+=3)S(t.getX(U+0)),S(t.getX(U+1)),S(t.getX(U+2))}}computeVertexNormals(){let t=this.index,n=this.getAttribute("position");if(n!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new Ze(new Float32Array(n.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let r=new Y,s=new Y,o=new Y,a=new Y,c=new Y,l=new Y,u=new Y,h=new Y;if(t)for(let f=0,d=t.count;f<d;f+=3){let m=t.getX(f+0),y=t.getX(f+1),g=t.getX(f+2);r.fromBufferAttribute(n,m),s.fromBufferAttribute(n,y),o.fromBufferAttribute(n,g),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),a.fromBufferAttribute(i,m),c.fromBufferAttribute(i,y),l.fromBufferAttribute(i,g),a.add(u),c.add(u),l.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(y,c.x,c.y,c.z),i.setXYZ(g,l.x,l.y,l.z)}else for(let f=0,d=n.count;f<d;f+=3)r.fromBufferAttribute(n,f+0),s.fromBufferAttribute(n,f+1),o.fromBufferAttribute(n,f+2),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let n=0,i=t.count;n<i;n++)qe.fromBufferAttribute(t,n),qe.normalize(),t.setXYZ(n,qe.x,qe.y,qe.z)}toNonIndexed(){function t(a,c){let l=a.array,u=a.itemSize,h=a.normalized,f=new l.constructor(c.length*u),d=0,m=0;for(let y=0,g=c.length;y<g;y++){a.isInterleavedBufferAttribute?d=c[y]*a.data.stride+a.offset:d=c[y]*u;for(let p=0;p<u;p++)f[m++]=l[d++]}return new Ze(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let n=new e,i=this.index.array,r=this.attributes;for(let a in r){let c=r[a],l=t(c,i);n.setAttribute(a,l)}let s=this.morphAttributes;for(let a in s){let c=[],l=s[a];for(let u=0,h=l.length;u<h;u++){let f=l[u],d=t(f,i);c.push(d)}n.morphAttributes[a]=c}n.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];n.addGroup(l.start,l.count,l.materialIndex)}return n}toJSON(){let t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let n=this.index;n!==null&&(t.data.index={type:n.array.constructor.name,array:Array.prototype.slice.call(n.array)});let i=this.attributes;for(let c in i){let l=i[c];t.data.attributes[c]=l.toJSON(t.data)}let r={},s=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],u=[];for(let h=0,f=l.length;h<f;h++){let d=l[h];u.push(d.toJSON(t.data))}u.length>0&&(r[c]=u,s=!0)}s&&(t.data.morphAttributes=r,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let n={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone(n));let r=t.attributes;for(let l in r){let u=r[l];this.setAttribute(l,u.clone(n))}let s=t.morphAttributes;for(let l in s){let u=[],h=s[l];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(n));this.morphAttributes[l]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,u=o.length;l<u;l++){let h=o[l];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},WT=new De,Js=new dl,Wf=new co,$T=new Y,$f=new Y,Xf=new Y,Yf=new Y,ey=new Y,qf=new Y,XT=new Y,Zf=new Y,yi=class extends Dn{constructor(t=new wn,n=new xh){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=n,this.updateMorphTargets()}copy(t,n){return super.copy(t,n),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let n=this.geometry.morphAttributes,i=Object.keys(n);if(i.length>0){let r=n[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(t,n){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;n.fromBufferAttribute(r,t);let a=this.morphTargetInfluences;if(s&&a){qf.set(0,0,0);for(let c=0,l=s.length;c<l;c++){let u=a[c],h=s[c];u!==0&&(ey.fromBufferAttribute(h,t),o?qf.addScaledVector(ey,u):qf.addScaledVector(ey.sub(n),u))}n.add(qf)}return n}raycast(t,n){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Wf.copy(i.boundingSphere),Wf.applyMatrix4(s),Js.copy(t.ray).recast(t.near),!(Wf.containsPoint(Js.origin)===!1&&(Js.intersectSphere(Wf,$T)===null||Js.origin.distanceToSquared($T)>(t.far-t.near)**2))&&(WT.copy(s).invert(),Js.copy(t.ray).applyMatrix4(WT),!(i.boundingBox!==null&&Js.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,n,Js)))}_computeIntersections(t,n,i){let r,s=this.geometry,o=this.material,a=s.index,c=s.attributes.position,l=s.attributes.uv,u=s.attributes.uv1,h=s.attributes.normal,f=s.groups,d=s.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let g=f[m],p=o[g.materialIndex],_=Math.max(g.start,d.start),b=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let x=_,C=b;x<C;x+=3){let w=a.getX(x),S=a.getX(x+1),R=a.getX(x+2);r=Jf(this,p,t,i,l,u,h,w,S,R),r&&(r.faceIndex=Math.floor(x/3),r.face.materialIndex=g.materialIndex,n.push(r))}}else{let m=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let g=m,p=y;g<p;g+=3){let _=a.getX(g),b=a.getX(g+1),x=a.getX(g+2);r=Jf(this,o,t,i,l,u,h,_,b,x),r&&(r.faceIndex=Math.floor(g/3),n.push(r))}}else if(c!==void 0)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let g=f[m],p=o[g.materialIndex],_=Math.max(g.start,d.start),b=Math.min(c.count,Math.min(g.start+g.count,d.start+d.count));for(let x=_,C=b;x<C;x+=3){let w=x,S=x+1,R=x+2;r=Jf(this,p,t,i,l,u,h,w,S,R),r&&(r.faceIndex=Math.floor(x/3),r.face.materialIndex=g.materialIndex,n.push(r))}}else{let m=Math.max(0,d.start),y=Math.min(c.count,d.start+d.count);for(let g=m,p=y;g<p;g+=3){let _=g,b=g+1,x=g+2;r=Jf(this,o,t,i,l,u,h,_,b,x),r&&(r.faceIndex=Math.floor(g/3),n.push(r))}}}};function D4(e,t,n,i,r,s,o,a){let c;if(t.side===Mn?c=i.intersectTriangle(o,s,r,!0,a):c=i.intersectTriangle(r,s,o,t.side===cs,a),c===null)return null;Zf.copy(a),Zf.applyMatrix4(e.matrixWorld);let l=n.ray.origin.distanceTo(Zf);return l<n.near||l>n.far?null:{distance:l,point:Zf.clone(),object:e}}function Jf(e,t,n,i,r,s,o,a,c,l){e.getVertexPosition(a,$f),e.getVertexPosition(c,Xf),e.getVertexPosition(l,Yf);let u=D4(e,t,n,i,$f,Xf,Yf,XT);if(u){let h=new Y;no.getBarycoord(XT,$f,Xf,Yf,h),r&&(u.uv=no.getInterpolatedAttribute(r,a,c,l,h,new le)),s&&(u.uv1=no.getInterpolatedAttribute(s,a,c,l,h,new le)),o&&(u.normal=no.getInterpolatedAttribute(o,a,c,l,h,new Y),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:c,c:l,normal:new Y,materialIndex:0};no.getNormal($f,Xf,Yf,f.normal),u.face=f,u.barycoord=h}return u}var pl=class e extends wn{constructor(t=1,n=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:n,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let c=[],l=[],u=[],h=[],f=0,d=0;m("z","y","x",-1,-1,i,n,t,o,s,0),m("z","y","x",1,-1,i,n,-t,o,s,1),m("x","z","y",1,1,t,i,n,r,o,2),m("x","z","y",1,-1,t,i,-n,r,o,3),m("x","y","z",1,-1,t,n,i,r,s,4),m("x","y","z",-1,-1,t,n,-i,r,s,5),this.setIndex(c),this.setAttribute("position",new xi(l,3)),this.setAttribute("normal",new xi(u,3)),this.setAttribute("uv",new xi(h,2));function m(y,g,p,_,b,x,C,w,S,R,M){let v=x/S,E=C/R,N=x/2,U=C/2,F=w/2,P=S+1,O=R+1,H=0,z=0,G=new Y;for(let j=0;j<O;j++){let nt=j*E-U;for(let ct=0;ct<P;ct++){let ft=ct*v-N;G[y]=ft*_,G[g]=nt*b,G[p]=F,l.push(G.x,G.y,G.z),G[y]=0,G[g]=0,G[p]=w>0?1:-1,u.push(G.x,G.y,G.z),h.push(ct/S),h.push(1-j/R),H+=1}}for(let j=0;j<R;j++)for(let nt=0;nt<S;nt++){let ct=f+nt+P*j,ft=f+nt+P*(j+1),$=f+(nt+1)+P*(j+1),tt=f+(nt+1)+P*j;c.push(ct,ft,tt),c.push(ft,$,tt),z+=6}a.addGroup(d,z,M),d+=z,f+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new e(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};function ka(e){let t={};for(let n in e){t[n]={};for(let i in e[n]){let r=e[n][i];r&&(r.isColor||r.isMatrix3||r.isMatrix4||r.isVector2||r.isVector3||r.isVector4||r.isTexture||r.isQuaternion)?r.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[n][i]=null):t[n][i]=r.clone():Array.isArray(r)?t[n][i]=r.slice():t[n][i]=r}}return t}function hn(e){let t={};for(let n=0;n<e.length;n++){let i=ka(e[n]);for(let r in i)t[r]=i[r]}return t}function U4(e){let t=[];for(let n=0;n<e.length;n++)t.push(e[n].clone());return t}function VE(e){let t=e.getRenderTarget();return t===null?e.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ee.workingColorSpace}var F4={clone:ka,merge:hn},O4=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,B4=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,_i=class extends fs{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=O4,this.fragmentShader=B4,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=ka(t.uniforms),this.uniformsGroups=U4(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){let n=super.toJSON(t);n.glslVersion=this.glslVersion,n.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?n.uniforms[r]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?n.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?n.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?n.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?n.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?n.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?n.uniforms[r]={type:"m4",value:o.toArray()}:n.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(n.defines=this.defines),n.vertexShader=this.vertexShader,n.fragmentShader=this.fragmentShader,n.lights=this.lights,n.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(n.extensions=i),n}},Mh=class extends Dn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new De,this.projectionMatrix=new De,this.projectionMatrixInverse=new De,this.coordinateSystem=wr}copy(t,n){return super.copy(t,n),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,n){super.updateWorldMatrix(t,n),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},is=new Y,YT=new le,qT=new le,dn=class extends Mh{constructor(t=50,n=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=n,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,n){return super.copy(t,n),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let n=.5*this.getFilmHeight()/t;this.fov=Jy*2*Math.atan(n),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(U0*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Jy*2*Math.atan(Math.tan(U0*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,n,i){is.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(is.x,is.y).multiplyScalar(-t/is.z),is.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(is.x,is.y).multiplyScalar(-t/is.z)}getViewSize(t,n){return this.getViewBounds(t,YT,qT),n.subVectors(qT,YT)}setViewOffset(t,n,i,r,s,o){this.aspect=t/n,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=n,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,n=t*Math.tan(U0*.5*this.fov)/this.zoom,i=2*n,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;s+=o.offsetX*r/c,n-=o.offsetY*i/l,r*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(s+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,n,n-i,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let n=super.toJSON(t);return n.object.fov=this.fov,n.object.zoom=this.zoom,n.object.near=this.near,n.object.far=this.far,n.object.focus=this.focus,n.object.aspect=this.aspect,this.view!==null&&(n.object.view=Object.assign({},this.view)),n.object.filmGauge=this.filmGauge,n.object.filmOffset=this.filmOffset,n}},Ea=-90,Aa=1,tx=class extends Dn{constructor(t,n,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new dn(Ea,Aa,t,n);r.layers=this.layers,this.add(r);let s=new dn(Ea,Aa,t,n);s.layers=this.layers,this.add(s);let o=new dn(Ea,Aa,t,n);o.layers=this.layers,this.add(o);let a=new dn(Ea,Aa,t,n);a.layers=this.layers,this.add(a);let c=new dn(Ea,Aa,t,n);c.layers=this.layers,this.add(c);let l=new dn(Ea,Aa,t,n);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,n=this.children.concat(),[i,r,s,o,a,c]=n;for(let l of n)this.remove(l);if(t===wr)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===dh)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of n)this.add(l),l.updateMatrixWorld()}update(t,n){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,c,l,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,t.setRenderTarget(i,0,r),t.render(n,s),t.setRenderTarget(i,1,r),t.render(n,o),t.setRenderTarget(i,2,r),t.render(n,a),t.setRenderTarget(i,3,r),t.render(n,c),t.setRenderTarget(i,4,r),t.render(n,l),i.texture.generateMipmaps=y,t.setRenderTarget(i,5,r),t.render(n,u),t.setRenderTarget(h,f,d),t.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},wh=class extends Nn{constructor(t,n,i,r,s,o,a,c,l,u){t=t!==void 0?t:[],n=n!==void 0?n:Ua,super(t,n,i,r,s,o,a,c,l,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},ex=class extends Er{constructor(t=1,n={}){super(t,t,n),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},r=[i,i,i,i,i,i];this.texture=new wh(r,n.mapping,n.wrapS,n.wrapT,n.magFilter,n.minFilter,n.format,n.type,n.anisotropy,n.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=n.generateMipmaps!==void 0?n.generateMipmaps:!1,this.texture.minFilter=n.minFilter!==void 0?n.minFilter:Wi}fromEquirectangularTexture(t,n){this.texture.type=n.type,this.texture.colorSpace=n.colorSpace,this.texture.generateMipmaps=n.generateMipmaps,this.texture.minFilter=n.minFilter,this.texture.magFilter=n.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},r=new pl(5,5,5),s=new _i({name:"CubemapFromEquirect",uniforms:ka(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Mn,blending:os});s.uniforms.tEquirect.value=n;let o=new yi(r,s),a=n.minFilter;return n.minFilter===so&&(n.minFilter=Wi),new tx(1,10,this).update(t,o),n.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,n,i,r){let s=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(n,i,r);t.setRenderTarget(s)}},ny=new Y,k4=new Y,z4=new Wt,vr=class{constructor(t=new Y(1,0,0),n=0){this.isPlane=!0,this.normal=t,this.constant=n}set(t,n){return this.normal.copy(t),this.constant=n,this}setComponents(t,n,i,r){return this.normal.set(t,n,i),this.constant=r,this}setFromNormalAndCoplanarPoint(t,n){return this.normal.copy(t),this.constant=-n.dot(this.normal),this}setFromCoplanarPoints(t,n,i){let r=ny.subVectors(i,n).cross(k4.subVectors(t,n)).normalize();return this.setFromNormalAndCoplanarPoint(r,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,n){return n.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,n){let i=t.delta(ny),r=this.normal.dot(i);if(r===0)return this.distanceToPoint(t.start)===0?n.copy(t.start):null;let s=-(t.start.dot(this.normal)+this.constant)/r;return s<0||s>1?null:n.copy(t.start).addScaledVector(i,s)}intersectsLine(t){let n=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return n<0&&i>0||i<0&&n>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,n){let i=n||z4.getNormalMatrix(t),r=this.coplanarPoint(ny).applyMatrix4(t),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}},Ks=new co,Kf=new Y,Sh=class{constructor(t=new vr,n=new vr,i=new vr,r=new vr,s=new vr,o=new vr){this.planes=[t,n,i,r,s,o]}set(t,n,i,r,s,o){let a=this.planes;return a[0].copy(t),a[1].copy(n),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(t){let n=this.planes;for(let i=0;i<6;i++)n[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,n=wr){let i=this.planes,r=t.elements,s=r[0],o=r[1],a=r[2],c=r[3],l=r[4],u=r[5],h=r[6],f=r[7],d=r[8],m=r[9],y=r[10],g=r[11],p=r[12],_=r[13],b=r[14],x=r[15];if(i[0].setComponents(c-s,f-l,g-d,x-p).normalize(),i[1].setComponents(c+s,f+l,g+d,x+p).normalize(),i[2].setComponents(c+o,f+u,g+m,x+_).normalize(),i[3].setComponents(c-o,f-u,g-m,x-_).normalize(),i[4].setComponents(c-a,f-h,g-y,x-b).normalize(),n===wr)i[5].setComponents(c+a,f+h,g+y,x+b).normalize();else if(n===dh)i[5].setComponents(a,h,y,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+n);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ks.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let n=t.geometry;n.boundingSphere===null&&n.computeBoundingSphere(),Ks.copy(n.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ks)}intersectsSprite(t){return Ks.center.set(0,0,0),Ks.radius=.7071067811865476,Ks.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ks)}intersectsSphere(t){let n=this.planes,i=t.center,r=-t.radius;for(let s=0;s<6;s++)if(n[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(t){let n=this.planes;for(let i=0;i<6;i++){let r=n[i];if(Kf.x=r.normal.x>0?t.max.x:t.min.x,Kf.y=r.normal.y>0?t.max.y:t.min.y,Kf.z=r.normal.z>0?t.max.z:t.min.z,r.distanceToPoint(Kf)<0)return!1}return!0}containsPoint(t){let n=this.planes;for(let i=0;i<6;i++)if(n[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};function HE(){let e=null,t=!1,n=null,i=null;function r(s,o){n(s,o),i=e.requestAnimationFrame(r)}return{start:function(){t!==!0&&n!==null&&(i=e.requestAnimationFrame(r),t=!0)},stop:function(){e.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(s){n=s},setContext:function(s){e=s}}}function V4(e){let t=new WeakMap;function n(a,c){let l=a.array,u=a.usage,h=l.byteLength,f=e.createBuffer();e.bindBuffer(c,f),e.bufferData(c,l,u),a.onUploadCallback();let d;if(l instanceof Float32Array)d=e.FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?d=e.HALF_FLOAT:d=e.UNSIGNED_SHORT;else if(l instanceof Int16Array)d=e.SHORT;else if(l instanceof Uint32Array)d=e.UNSIGNED_INT;else if(l instanceof Int32Array)d=e.INT;else if(l instanceof Int8Array)d=e.BYTE;else if(l instanceof Uint8Array)d=e.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)d=e.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:f,type:d,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,c,l){let u=c.array,h=c.updateRanges;if(e.bindBuffer(l,a),h.length===0)e.bufferSubData(l,0,u);else{h.sort((d,m)=>d.start-m.start);let f=0;for(let d=1;d<h.length;d++){let m=h[f],y=h[d];y.start<=m.start+m.count+1?m.count=Math.max(m.count,y.start+y.count-m.start):(++f,h[f]=y)}h.length=f+1;for(let d=0,m=h.length;d<m;d++){let y=h[d];e.bufferSubData(l,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}c.clearUpdateRanges()}c.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(e.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,n(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:r,remove:s,update:o}}var Th=class e extends wn{constructor(t=1,n=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:n,widthSegments:i,heightSegments:r};let s=t/2,o=n/2,a=Math.floor(i),c=Math.floor(r),l=a+1,u=c+1,h=t/a,f=n/c,d=[],m=[],y=[],g=[];for(let p=0;p<u;p++){let _=p*f-o;for(let b=0;b<l;b++){let x=b*h-s;m.push(x,-_,0),y.push(0,0,1),g.push(b/a),g.push(1-p/c)}}for(let p=0;p<c;p++)for(let _=0;_<a;_++){let b=_+l*p,x=_+l*(p+1),C=_+1+l*(p+1),w=_+1+l*p;d.push(b,x,w),d.push(x,C,w)}this.setIndex(d),this.setAttribute("position",new xi(m,3)),this.setAttribute("normal",new xi(y,3)),this.setAttribute("uv",new xi(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new e(t.width,t.height,t.widthSegments,t.heightSegments)}},H4=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,G4=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,W4=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,$4=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,X4=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Y4=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,q4=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Z4=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,J4=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,K4=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,j4=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Q4=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,t5=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,e5=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,n5=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,i5=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,r5=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,s5=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,o5=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,a5=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,c5=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,l5=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,u5=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,f5=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,h5=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,d5=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,p5=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,m5=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,g5=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,y5=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,x5="gl_FragColor = linearToOutputTexel( gl_FragColor );",_5=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,v5=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,b5=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,M5=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,w5=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,S5=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,T5=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,E5=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,A5=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,C5=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,R5=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,I5=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,P5=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,L5=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,N5=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,D5=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,U5=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,F5=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,O5=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,B5=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,k5=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,z5=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,V5=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,H5=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,G5=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,W5=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,$5=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,X5=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Y5=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,q5=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Z5=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,J5=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,K5=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,j5=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Q5=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,tF=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,eF=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,nF=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,iF=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,rF=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,sF=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,oF=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,aF=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,cF=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,lF=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,uF=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,fF=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,hF=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,dF=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,pF=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,mF=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,gF=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,yF=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,xF=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,_F=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,vF=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,bF=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,MF=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,wF=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,SF=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,TF=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,EF=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,AF=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,CF=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,RF=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,IF=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,PF=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,LF=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,NF=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,DF=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,UF=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,FF=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
		
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
		
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		
		#else
		
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,OF=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,BF=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,kF=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,zF=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,VF=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,HF=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,GF=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,WF=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$F=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,XF=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,YF=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,qF=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,ZF=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,JF=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,KF=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,jF=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,QF=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,tO=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,eO=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,nO=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,iO=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,rO=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,sO=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,oO=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,aO=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,cO=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,lO=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,uO=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,fO=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,hO=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,dO=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,pO=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mO=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,gO=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,yO=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,xO=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,_O=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,vO=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Yt={alphahash_fragment:H4,alphahash_pars_fragment:G4,alphamap_fragment:W4,alphamap_pars_fragment:$4,alphatest_fragment:X4,alphatest_pars_fragment:Y4,aomap_fragment:q4,aomap_pars_fragment:Z4,batching_pars_vertex:J4,batching_vertex:K4,begin_vertex:j4,beginnormal_vertex:Q4,bsdfs:t5,iridescence_fragment:e5,bumpmap_pars_fragment:n5,clipping_planes_fragment:i5,clipping_planes_pars_fragment:r5,clipping_planes_pars_vertex:s5,clipping_planes_vertex:o5,color_fragment:a5,color_pars_fragment:c5,color_pars_vertex:l5,color_vertex:u5,common:f5,cube_uv_reflection_fragment:h5,defaultnormal_vertex:d5,displacementmap_pars_vertex:p5,displacementmap_vertex:m5,emissivemap_fragment:g5,emissivemap_pars_fragment:y5,colorspace_fragment:x5,colorspace_pars_fragment:_5,envmap_fragment:v5,envmap_common_pars_fragment:b5,envmap_pars_fragment:M5,envmap_pars_vertex:w5,envmap_physical_pars_fragment:D5,envmap_vertex:S5,fog_vertex:T5,fog_pars_vertex:E5,fog_fragment:A5,fog_pars_fragment:C5,gradientmap_pars_fragment:R5,lightmap_pars_fragment:I5,lights_lambert_fragment:P5,lights_lambert_pars_fragment:L5,lights_pars_begin:N5,lights_toon_fragment:U5,lights_toon_pars_fragment:F5,lights_phong_fragment:O5,lights_phong_pars_fragment:B5,lights_physical_fragment:k5,lights_physical_pars_fragment:z5,lights_fragment_begin:V5,lights_fragment_maps:H5,lights_fragment_end:G5,logdepthbuf_fragment:W5,logdepthbuf_pars_fragment:$5,logdepthbuf_pars_vertex:X5,logdepthbuf_vertex:Y5,map_fragment:q5,map_pars_fragment:Z5,map_particle_fragment:J5,map_particle_pars_fragment:K5,metalnessmap_fragment:j5,metalnessmap_pars_fragment:Q5,morphinstance_vertex:tF,morphcolor_vertex:eF,morphnormal_vertex:nF,morphtarget_pars_vertex:iF,morphtarget_vertex:rF,normal_fragment_begin:sF,normal_fragment_maps:oF,normal_pars_fragment:aF,normal_pars_vertex:cF,normal_vertex:lF,normalmap_pars_fragment:uF,clearcoat_normal_fragment_begin:fF,clearcoat_normal_fragment_maps:hF,clearcoat_pars_fragment:dF,iridescence_pars_fragment:pF,opaque_fragment:mF,packing:gF,premultiplied_alpha_fragment:yF,project_vertex:xF,dithering_fragment:_F,dithering_pars_fragment:vF,roughnessmap_fragment:bF,roughnessmap_pars_fragment:MF,shadowmap_pars_fragment:wF,shadowmap_pars_vertex:SF,shadowmap_vertex:TF,shadowmask_pars_fragment:EF,skinbase_vertex:AF,skinning_pars_vertex:CF,skinning_vertex:RF,skinnormal_vertex:IF,specularmap_fragment:PF,specularmap_pars_fragment:LF,tonemapping_fragment:NF,tonemapping_pars_fragment:DF,transmission_fragment:UF,transmission_pars_fragment:FF,uv_pars_fragment:OF,uv_pars_vertex:BF,uv_vertex:kF,worldpos_vertex:zF,background_vert:VF,background_frag:HF,backgroundCube_vert:GF,backgroundCube_frag:WF,cube_vert:$F,cube_frag:XF,depth_vert:YF,depth_frag:qF,distanceRGBA_vert:ZF,distanceRGBA_frag:JF,equirect_vert:KF,equirect_frag:jF,linedashed_vert:QF,linedashed_frag:tO,meshbasic_vert:eO,meshbasic_frag:nO,meshlambert_vert:iO,meshlambert_frag:rO,meshmatcap_vert:sO,meshmatcap_frag:oO,meshnormal_vert:aO,meshnormal_frag:cO,meshphong_vert:lO,meshphong_frag:uO,meshphysical_vert:fO,meshphysical_frag:hO,meshtoon_vert:dO,meshtoon_frag:pO,points_vert:mO,points_frag:gO,shadow_vert:yO,shadow_frag:xO,sprite_vert:_O,sprite_frag:vO},gt={common:{diffuse:{value:new Kt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Wt},alphaMap:{value:null},alphaMapTransform:{value:new Wt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Wt}},envmap:{envMap:{value:null},envMapRotation:{value:new Wt},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Wt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Wt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Wt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Wt},normalScale:{value:new le(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Wt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Wt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Wt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Wt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Kt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new Kt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Wt},alphaTest:{value:0},uvTransform:{value:new Wt}},sprite:{diffuse:{value:new Kt(16777215)},opacity:{value:1},center:{value:new le(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Wt},alphaMap:{value:null},alphaMapTransform:{value:new Wt},alphaTest:{value:0}}},Gi={basic:{uniforms:hn([gt.common,gt.specularmap,gt.envmap,gt.aomap,gt.lightmap,gt.fog]),vertexShader:Yt.meshbasic_vert,fragmentShader:Yt.meshbasic_frag},lambert:{uniforms:hn([gt.common,gt.specularmap,gt.envmap,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.fog,gt.lights,{emissive:{value:new Kt(0)}}]),vertexShader:Yt.meshlambert_vert,fragmentShader:Yt.meshlambert_frag},phong:{uniforms:hn([gt.common,gt.specularmap,gt.envmap,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.fog,gt.lights,{emissive:{value:new Kt(0)},specular:{value:new Kt(1118481)},shininess:{value:30}}]),vertexShader:Yt.meshphong_vert,fragmentShader:Yt.meshphong_frag},standard:{uniforms:hn([gt.common,gt.envmap,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.roughnessmap,gt.metalnessmap,gt.fog,gt.lights,{emissive:{value:new Kt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Yt.meshphysical_vert,fragmentShader:Yt.meshphysical_frag},toon:{uniforms:hn([gt.common,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.gradientmap,gt.fog,gt.lights,{emissive:{value:new Kt(0)}}]),vertexShader:Yt.meshtoon_vert,fragmentShader:Yt.meshtoon_frag},matcap:{uniforms:hn([gt.common,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.fog,{matcap:{value:null}}]),vertexShader:Yt.meshmatcap_vert,fragmentShader:Yt.meshmatcap_frag},points:{uniforms:hn([gt.points,gt.fog]),vertexShader:Yt.points_vert,fragmentShader:Yt.points_frag},dashed:{uniforms:hn([gt.common,gt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Yt.linedashed_vert,fragmentShader:Yt.linedashed_frag},depth:{uniforms:hn([gt.common,gt.displacementmap]),vertexShader:Yt.depth_vert,fragmentShader:Yt.depth_frag},normal:{uniforms:hn([gt.common,gt.bumpmap,gt.normalmap,gt.displacementmap,{opacity:{value:1}}]),vertexShader:Yt.meshnormal_vert,fragmentShader:Yt.meshnormal_frag},sprite:{uniforms:hn([gt.sprite,gt.fog]),vertexShader:Yt.sprite_vert,fragmentShader:Yt.sprite_frag},background:{uniforms:{uvTransform:{value:new Wt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Yt.background_vert,fragmentShader:Yt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Wt}},vertexShader:Yt.backgroundCube_vert,fragmentShader:Yt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Yt.cube_vert,fragmentShader:Yt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Yt.equirect_vert,fragmentShader:Yt.equirect_frag},distanceRGBA:{uniforms:hn([gt.common,gt.displacementmap,{referencePosition:{value:new Y},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Yt.distanceRGBA_vert,fragmentShader:Yt.distanceRGBA_frag},shadow:{uniforms:hn([gt.lights,gt.fog,{color:{value:new Kt(0)},opacity:{value:1}}]),vertexShader:Yt.shadow_vert,fragmentShader:Yt.shadow_frag}};Gi.physical={uniforms:hn([Gi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Wt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Wt},clearcoatNormalScale:{value:new le(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Wt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Wt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Wt},sheen:{value:0},sheenColor:{value:new Kt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Wt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Wt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Wt},transmissionSamplerSize:{value:new le},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Wt},attenuationDistance:{value:0},attenuationColor:{value:new Kt(0)},specularColor:{value:new Kt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Wt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Wt},anisotropyVector:{value:new le},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Wt}}]),vertexShader:Yt.meshphysical_vert,fragmentShader:Yt.meshphysical_frag};var jf={r:0,b:0,g:0},js=new Ar,bO=new De;function MO(e,t,n,i,r,s,o){let a=new Kt(0),c=s===!0?0:1,l,u,h=null,f=0,d=null;function m(_){let b=_.isScene===!0?_.background:null;return b&&b.isTexture&&(b=(_.backgroundBlurriness>0?n:t).get(b)),b}function y(_){let b=!1,x=m(_);x===null?p(a,c):x&&x.isColor&&(p(x,1),b=!0);let C=e.xr.getEnvironmentBlendMode();C==="additive"?i.buffers.color.setClear(0,0,0,1,o):C==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(e.autoClear||b)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),e.clear(e.autoClearColor,e.autoClearDepth,e.autoClearStencil))}function g(_,b){let x=m(b);x&&(x.isCubeTexture||x.mapping===Fh)?(u===void 0&&(u=new yi(new pl(1,1,1),new _i({name:"BackgroundCubeMaterial",uniforms:ka(Gi.backgroundCube.uniforms),vertexShader:Gi.backgroundCube.vertexShader,fragmentShader:Gi.backgroundCube.fragmentShader,side:Mn,depthTest:!1,depthWrite:!1,fog:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(C,w,S){this.matrixWorld.copyPosition(S.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),r.update(u)),js.copy(b.backgroundRotation),js.x*=-1,js.y*=-1,js.z*=-1,x.isCubeTexture&&x.isRenderTargetTexture===!1&&(js.y*=-1,js.z*=-1),u.material.uniforms.envMap.value=x,u.material.uniforms.flipEnvMap.value=x.isCubeTexture&&x.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(bO.makeRotationFromEuler(js)),u.material.toneMapped=ee.getTransfer(x.colorSpace)!==pe,(h!==x||f!==x.version||d!==e.toneMapping)&&(u.material.needsUpdate=!0,h=x,f=x.version,d=e.toneMapping),u.layers.enableAll(),_.unshift(u,u.geometry,u.material,0,0,null)):x&&x.isTexture&&(l===void 0&&(l=new yi(new Th(2,2),new _i({name:"BackgroundMaterial",uniforms:ka(Gi.background.uniforms),vertexShader:Gi.background.vertexShader,fragmentShader:Gi.background.fragmentShader,side:cs,depthTest:!1,depthWrite:!1,fog:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),r.update(l)),l.material.uniforms.t2D.value=x,l.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,l.material.toneMapped=ee.getTransfer(x.colorSpace)!==pe,x.matrixAutoUpdate===!0&&x.updateMatrix(),l.material.uniforms.uvTransform.value.copy(x.matrix),(h!==x||f!==x.version||d!==e.toneMapping)&&(l.material.needsUpdate=!0,h=x,f=x.version,d=e.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function p(_,b){_.getRGB(jf,VE(e)),i.buffers.color.setClear(jf.r,jf.g,jf.b,b,o)}return{getClearColor:function(){return a},setClearColor:function(_,b=1){a.set(_),c=b,p(a,c)},getClearAlpha:function(){return c},setClearAlpha:function(_){c=_,p(a,c)},render:y,addToRenderList:g}}function wO(e,t){let n=e.getParameter(e.MAX_VERTEX_ATTRIBS),i={},r=f(null),s=r,o=!1;function a(v,E,N,U,F){let P=!1,O=h(U,N,E);s!==O&&(s=O,l(s.object)),P=d(v,U,N,F),P&&m(v,U,N,F),F!==null&&t.update(F,e.ELEMENT_ARRAY_BUFFER),(P||o)&&(o=!1,x(v,E,N,U),F!==null&&e.bindBuffer(e.ELEMENT_ARRAY_BUFFER,t.get(F).buffer))}function c(){return e.createVertexArray()}function l(v){return e.bindVertexArray(v)}function u(v){return e.deleteVertexArray(v)}function h(v,E,N){let U=N.wireframe===!0,F=i[v.id];F===void 0&&(F={},i[v.id]=F);let P=F[E.id];P===void 0&&(P={},F[E.id]=P);let O=P[U];return O===void 0&&(O=f(c()),P[U]=O),O}function f(v){let E=[],N=[],U=[];for(let F=0;F<n;F++)E[F]=0,N[F]=0,U[F]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:E,enabledAttributes:N,attributeDivisors:U,object:v,attributes:{},index:null}}function d(v,E,N,U){let F=s.attributes,P=E.attributes,O=0,H=N.getAttributes();for(let z in H)if(H[z].location>=0){let j=F[z],nt=P[z];if(nt===void 0&&(z==="instanceMatrix"&&v.instanceMatrix&&(nt=v.instanceMatrix),z==="instanceColor"&&v.instanceColor&&(nt=v.instanceColor)),j===void 0||j.attribute!==nt||nt&&j.data!==nt.data)return!0;O++}return s.attributesNum!==O||s.index!==U}function m(v,E,N,U){let F={},P=E.attributes,O=0,H=N.getAttributes();for(let z in H)if(H[z].location>=0){let j=P[z];j===void 0&&(z==="instanceMatrix"&&v.instanceMatrix&&(j=v.instanceMatrix),z==="instanceColor"&&v.instanceColor&&(j=v.instanceColor));let nt={};nt.attribute=j,j&&j.data&&(nt.data=j.data),F[z]=nt,O++}s.attributes=F,s.attributesNum=O,s.index=U}function y(){let v=s.newAttributes;for(let E=0,N=v.length;E<N;E++)v[E]=0}function g(v){p(v,0)}function p(v,E){let N=s.newAttributes,U=s.enabledAttributes,F=s.attributeDivisors;N[v]=1,U[v]===0&&(e.enableVertexAttribArray(v),U[v]=1),F[v]!==E&&(e.vertexAttribDivisor(v,E),F[v]=E)}function _(){let v=s.newAttributes,E=s.enabledAttributes;for(let N=0,U=E.length;N<U;N++)E[N]!==v[N]&&(e.disableVertexAttribArray(N),E[N]=0)}function b(v,E,N,U,F,P,O){O===!0?e.vertexAttribIPointer(v,E,N,F,P):e.vertexAttribPointer(v,E,N,U,F,P)}function x(v,E,N,U){y();let F=U.attributes,P=N.getAttributes(),O=E.defaultAttributeValues;for(let H in P){let z=P[H];if(z.location>=0){let G=F[H];if(G===void 0&&(H==="instanceMatrix"&&v.instanceMatrix&&(G=v.instanceMatrix),H==="instanceColor"&&v.instanceColor&&(G=v.instanceColor)),G!==void 0){let j=G.normalized,nt=G.itemSize,ct=t.get(G);if(ct===void 0)continue;let ft=ct.buffer,$=ct.type,tt=ct.bytesPerElement,lt=$===e.INT||$===e.UNSIGNED_INT||G.gpuType===Cx;if(G.isInterleavedBufferAttribute){let K=G.data,ut=K.stride,q=G.offset;if(K.isInstancedInterleavedBuffer){for(let ot=0;ot<z.locationSize;ot++)p(z.location+ot,K.meshPerAttribute);v.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let ot=0;ot<z.locationSize;ot++)g(z.location+ot);e.bindBuffer(e.ARRAY_BUFFER,ft);for(let ot=0;ot<z.locationSize;ot++)b(z.location+ot,nt/z.locationSize,$,j,ut*tt,(q+nt/z.locationSize*ot)*tt,lt)}else{if(G.isInstancedBufferAttribute){for(let K=0;K<z.locationSize;K++)p(z.location+K,G.meshPerAttribute);v.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=G.meshPerAttribute*G.count)}else for(let K=0;K<z.locationSize;K++)g(z.location+K);e.bindBuffer(e.ARRAY_BUFFER,ft);for(let K=0;K<z.locationSize;K++)b(z.location+K,nt/z.locationSize,$,j,nt*tt,nt/z.locationSize*K*tt,lt)}}else if(O!==void 0){let j=O[H];if(j!==void 0)switch(j.length){case 2:e.vertexAttrib2fv(z.location,j);break;case 3:e.vertexAttrib3fv(z.location,j);break;case 4:e.vertexAttrib4fv(z.location,j);break;default:e.vertexAttrib1fv(z.location,j)}}}}_()}function C(){R();for(let v in i){let E=i[v];for(let N in E){let U=E[N];for(let F in U)u(U[F].object),delete U[F];delete E[N]}delete i[v]}}function w(v){if(i[v.id]===void 0)return;let E=i[v.id];for(let N in E){let U=E[N];for(let F in U)u(U[F].object),delete U[F];delete E[N]}delete i[v.id]}function S(v){for(let E in i){let N=i[E];if(N[v.id]===void 0)continue;let U=N[v.id];for(let F in U)u(U[F].object),delete U[F];delete N[v.id]}}function R(){M(),o=!0,s!==r&&(s=r,l(s.object))}function M(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:R,resetDefaultState:M,dispose:C,releaseStatesOfGeometry:w,releaseStatesOfProgram:S,initAttributes:y,enableAttribute:g,disableUnusedAttributes:_}}function SO(e,t,n){let i;function r(l){i=l}function s(l,u){e.drawArrays(i,l,u),n.update(u,i,1)}function o(l,u,h){h!==0&&(e.drawArraysInstanced(i,l,u,h),n.update(u,i,h))}function a(l,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,u,0,h);let d=0;for(let m=0;m<h;m++)d+=u[m];n.update(d,i,1)}function c(l,u,h,f){if(h===0)return;let d=t.get("WEBGL_multi_draw");if(d===null)for(let m=0;m<l.length;m++)o(l[m],u[m],f[m]);else{d.multiDrawArraysInstancedWEBGL(i,l,0,u,0,f,0,h);let m=0;for(let y=0;y<h;y++)m+=u[y]*f[y];n.update(m,i,1)}}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=c}function TO(e,t,n,i){let r;function s(){if(r!==void 0)return r;if(t.has("EXT_texture_filter_anisotropic")===!0){let S=t.get("EXT_texture_filter_anisotropic");r=e.getParameter(S.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(S){return!(S!==Pn&&i.convert(S)!==e.getParameter(e.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(S){let R=S===gl&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(S!==Tr&&i.convert(S)!==e.getParameter(e.IMPLEMENTATION_COLOR_READ_TYPE)&&S!==Mr&&!R)}function c(S){if(S==="highp"){if(e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.HIGH_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.HIGH_FLOAT).precision>0)return"highp";S="mediump"}return S==="mediump"&&e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.MEDIUM_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=n.precision!==void 0?n.precision:"highp",u=c(l);u!==l&&(console.warn("THREE.WebGLRenderer:",l,"not supported, using",u,"instead."),l=u);let h=n.logarithmicDepthBuffer===!0,f=n.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.getParameter(e.MAX_TEXTURE_IMAGE_UNITS),m=e.getParameter(e.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=e.getParameter(e.MAX_TEXTURE_SIZE),g=e.getParameter(e.MAX_CUBE_MAP_TEXTURE_SIZE),p=e.getParameter(e.MAX_VERTEX_ATTRIBS),_=e.getParameter(e.MAX_VERTEX_UNIFORM_VECTORS),b=e.getParameter(e.MAX_VARYING_VECTORS),x=e.getParameter(e.MAX_FRAGMENT_UNIFORM_VECTORS),C=m>0,w=e.getParameter(e.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:h,reverseDepthBuffer:f,maxTextures:d,maxVertexTextures:m,maxTextureSize:y,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:_,maxVaryings:b,maxFragmentUniforms:x,vertexTextures:C,maxSamples:w}}function EO(e){let t=this,n=null,i=0,r=!1,s=!1,o=new vr,a=new Wt,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||i!==0||r;return r=f,i=h.length,d},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(h,f){n=u(h,f,0)},this.setState=function(h,f,d){let m=h.clippingPlanes,y=h.clipIntersection,g=h.clipShadows,p=e.get(h);if(!r||m===null||m.length===0||s&&!g)s?u(null):l();else{let _=s?0:i,b=_*4,x=p.clippingState||null;c.value=x,x=u(m,f,b,d);for(let C=0;C!==b;++C)x[C]=n[C];p.clippingState=x,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=_}};function l(){c.value!==n&&(c.value=n,c.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,f,d,m){let y=h!==null?h.length:0,g=null;if(y!==0){if(g=c.value,m!==!0||g===null){let p=d+y*4,_=f.matrixWorldInverse;a.getNormalMatrix(_),(g===null||g.length<p)&&(g=new Float32Array(p));for(let b=0,x=d;b!==y;++b,x+=4)o.copy(h[b]).applyMatrix4(_,a),o.normal.toArray(g,x),g[x+3]=o.constant}c.value=g,c.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,g}}function AO(e){let t=new WeakMap;function n(o,a){return a===_y?o.mapping=Ua:a===vy&&(o.mapping=Fa),o}function i(o){if(o&&o.isTexture){let a=o.mapping;if(a===_y||a===vy)if(t.has(o)){let c=t.get(o).texture;return n(c,o.mapping)}else{let c=o.image;if(c&&c.height>0){let l=new ex(c.height);return l.fromEquirectangularTexture(e,o),t.set(o,l),o.addEventListener("dispose",r),n(l.texture,o.mapping)}else return null}}return o}function r(o){let a=o.target;a.removeEventListener("dispose",r);let c=t.get(a);c!==void 0&&(t.delete(a),c.dispose())}function s(){t=new WeakMap}return{get:i,dispose:s}}var nx=class extends Mh{constructor(t=-1,n=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=n,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(t,n){return super.copy(t,n),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,n,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=n,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),n=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-t,o=i+t,a=r+n,c=r-n;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=l*this.view.offsetX,o=s+l*this.view.width,a-=u*this.view.offsetY,c=a-u*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,c,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let n=super.toJSON(t);return n.object.zoom=this.zoom,n.object.left=this.left,n.object.right=this.right,n.object.top=this.top,n.object.bottom=this.bottom,n.object.near=this.near,n.object.far=this.far,this.view!==null&&(n.object.view=Object.assign({},this.view)),n}},Ra=4,ZT=[.125,.215,.35,.446,.526,.582],io=20,iy=new nx,JT=new Kt,ry=null,sy=0,oy=0,ay=!1,to=(1+Math.sqrt(5))/2,Ca=1/to,KT=[new Y(-to,Ca,0),new Y(to,Ca,0),new Y(-Ca,0,to),new Y(Ca,0,to),new Y(0,to,-Ca),new Y(0,to,Ca),new Y(-1,1,-1),new Y(1,1,-1),new Y(-1,1,1),new Y(1,1,1)],Eh=class{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,n=0,i=.1,r=100){ry=this._renderer.getRenderTarget(),sy=this._renderer.getActiveCubeFace(),oy=this._renderer.getActiveMipmapLevel(),ay=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);let s=this._allocateTargets();return s.depthBuffer=!0,this._sceneToCubeUV(t,i,r,s),n>0&&this._blur(s,0,0,n),this._applyPMREM(s),this._cleanup(s),s}fromEquirectangular(t,n=null){return this._fromTexture(t,n)}fromCubemap(t,n=null){return this._fromTexture(t,n)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=tE(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=QT(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(ry,sy,oy),this._renderer.xr.enabled=ay,t.scissorTest=!1,Qf(t,0,0,t.width,t.height)}_fromTexture(t,n){t.mapping===Ua||t.mapping===Fa?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),ry=this._renderer.getRenderTarget(),sy=this._renderer.getActiveCubeFace(),oy=this._renderer.getActiveMipmapLevel(),ay=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let i=n||this._allocateTargets();return this._textureToCubeUV(t,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){let t=3*Math.max(this._cubeSize,112),n=4*this._cubeSize,i={magFilter:Wi,minFilter:Wi,generateMipmaps:!1,type:gl,format:Pn,colorSpace:Ha,depthBuffer:!1},r=jT(t,n,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==n){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=jT(t,n,i);let{_lodMax:s}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=CO(s)),this._blurMaterial=RO(s,t,n)}return r}_compileMaterial(t){let n=new yi(this._lodPlanes[0],t);this._renderer.compile(n,iy)}_sceneToCubeUV(t,n,i,r){let a=new dn(90,1,n,i),c=[1,-1,1,1,1,1],l=[1,1,1,-1,-1,-1],u=this._renderer,h=u.autoClear,f=u.toneMapping;u.getClearColor(JT),u.toneMapping=as,u.autoClear=!1;let d=new xh({name:"PMREM.Background",side:Mn,depthWrite:!1,depthTest:!1}),m=new yi(new pl,d),y=!1,g=t.background;g?g.isColor&&(d.color.copy(g),t.background=null,y=!0):(d.color.copy(JT),y=!0);for(let p=0;p<6;p++){let _=p%3;_===0?(a.up.set(0,c[p],0),a.lookAt(l[p],0,0)):_===1?(a.up.set(0,0,c[p]),a.lookAt(0,l[p],0)):(a.up.set(0,c[p],0),a.lookAt(0,0,l[p]));let b=this._cubeSize;Qf(r,_*b,p>2?b:0,b,b),u.setRenderTarget(r),y&&u.render(m,a),u.render(t,a)}m.geometry.dispose(),m.material.dispose(),u.toneMapping=f,u.autoClear=h,t.background=g}_textureToCubeUV(t,n){let i=this._renderer,r=t.mapping===Ua||t.mapping===Fa;r?(this._cubemapMaterial===null&&(this._cubemapMaterial=tE()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=QT());let s=r?this._cubemapMaterial:this._equirectMaterial,o=new yi(this._lodPlanes[0],s),a=s.uniforms;a.envMap.value=t;let c=this._cubeSize;Qf(n,0,0,3*c,2*c),i.setRenderTarget(n),i.render(o,iy)}_applyPMREM(t){let n=this._renderer,i=n.autoClear;n.autoClear=!1;let r=this._lodPlanes.length;for(let s=1;s<r;s++){let o=Math.sqrt(this._sigmas[s]*this._sigmas[s]-this._sigmas[s-1]*this._sigmas[s-1]),a=KT[(r-s-1)%KT.length];this._blur(t,s-1,s,o,a)}n.autoClear=i}_blur(t,n,i,r,s){let o=this._pingPongRenderTarget;this._halfBlur(t,o,n,i,r,"latitudinal",s),this._halfBlur(o,t,i,i,r,"longitudinal",s)}_halfBlur(t,n,i,r,s,o,a){let c=this._renderer,l=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let u=3,h=new yi(this._lodPlanes[r],l),f=l.uniforms,d=this._sizeLods[i]-1,m=isFinite(s)?Math.PI/(2*d):2*Math.PI/(2*io-1),y=s/m,g=isFinite(s)?1+Math.floor(u*y):io;g>io&&console.warn(`sigmaRadians, ${s}, is too large and will clip, as it requested ${g} samples when the maximum is set to ${io}`);let p=[],_=0;for(let S=0;S<io;++S){let R=S/y,M=Math.exp(-R*R/2);p.push(M),S===0?_+=M:S<g&&(_+=2*M)}for(let S=0;S<p.length;S++)p[S]=p[S]/_;f.envMap.value=t.texture,f.samples.value=g,f.weights.value=p,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:b}=this;f.dTheta.value=m,f.mipInt.value=b-i;let x=this._sizeLods[r],C=3*x*(r>b-Ra?r-b+Ra:0),w=4*(this._cubeSize-x);Qf(n,C,w,3*x,2*x),c.setRenderTarget(n),c.render(h,iy)}};function CO(e){let t=[],n=[],i=[],r=e,s=e-Ra+1+ZT.length;for(let o=0;o<s;o++){let a=Math.pow(2,r);n.push(a);let c=1/a;o>e-Ra?c=ZT[o-e+Ra-1]:o===0&&(c=0),i.push(c);let l=1/(a-2),u=-l,h=1+l,f=[u,u,h,u,h,h,u,u,h,h,u,h],d=6,m=6,y=3,g=2,p=1,_=new Float32Array(y*m*d),b=new Float32Array(g*m*d),x=new Float32Array(p*m*d);for(let w=0;w<d;w++){let S=w%3*2/3-1,R=w>2?0:-1,M=[S,R,0,S+2/3,R,0,S+2/3,R+1,0,S,R,0,S+2/3,R+1,0,S,R+1,0];_.set(M,y*m*w),b.set(f,g*m*w);let v=[w,w,w,w,w,w];x.set(v,p*m*w)}let C=new wn;C.setAttribute("position",new Ze(_,y)),C.setAttribute("uv",new Ze(b,g)),C.setAttribute("faceIndex",new Ze(x,p)),t.push(C),r>Ra&&r--}return{lodPlanes:t,sizeLods:n,sigmas:i}}function jT(e,t,n){let i=new Er(e,t,n);return i.texture.mapping=Fh,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function Qf(e,t,n,i,r){e.viewport.set(t,n,i,r),e.scissor.set(t,n,i,r)}function RO(e,t,n){let i=new Float32Array(io),r=new Y(0,1,0);return new _i({name:"SphericalGaussianBlur",defines:{n:io,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/n,CUBEUV_MAX_MIP:`${e}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:r}},vertexShader:Dx(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:os,depthTest:!1,depthWrite:!1})}function QT(){return new _i({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Dx(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:os,depthTest:!1,depthWrite:!1})}function tE(){return new _i({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Dx(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:os,depthTest:!1,depthWrite:!1})}function Dx(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function IO(e){let t=new WeakMap,n=null;function i(a){if(a&&a.isTexture){let c=a.mapping,l=c===_y||c===vy,u=c===Ua||c===Fa;if(l||u){let h=t.get(a),f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return n===null&&(n=new Eh(e)),h=l?n.fromEquirectangular(a,h):n.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),h.texture;if(h!==void 0)return h.texture;{let d=a.image;return l&&d&&d.height>0||u&&d&&r(d)?(n===null&&(n=new Eh(e)),h=l?n.fromEquirectangular(a):n.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),a.addEventListener("dispose",s),h.texture):null}}}return a}function r(a){let c=0,l=6;for(let u=0;u<l;u++)a[u]!==void 0&&c++;return c===l}function s(a){let c=a.target;c.removeEventListener("dispose",s);let l=t.get(c);l!==void 0&&(t.delete(c),l.dispose())}function o(){t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:i,dispose:o}}function PO(e){let t={};function n(i){if(t[i]!==void 0)return t[i];let r;switch(i){case"WEBGL_depth_texture":r=e.getExtension("WEBGL_depth_texture")||e.getExtension("MOZ_WEBGL_depth_texture")||e.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":r=e.getExtension("EXT_texture_filter_anisotropic")||e.getExtension("MOZ_EXT_texture_filter_anisotropic")||e.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":r=e.getExtension("WEBGL_compressed_texture_s3tc")||e.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||e.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":r=e.getExtension("WEBGL_compressed_texture_pvrtc")||e.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:r=e.getExtension(i)}return t[i]=r,r}return{has:function(i){return n(i)!==null},init:function(){n("EXT_color_buffer_float"),n("WEBGL_clip_cull_distance"),n("OES_texture_float_linear"),n("EXT_color_buffer_half_float"),n("WEBGL_multisampled_render_to_texture"),n("WEBGL_render_shared_exponent")},get:function(i){let r=n(i);return r===null&&ll("THREE.WebGLRenderer: "+i+" extension not supported."),r}}}function LO(e,t,n,i){let r={},s=new WeakMap;function o(h){let f=h.target;f.index!==null&&t.remove(f.index);for(let m in f.attributes)t.remove(f.attributes[m]);for(let m in f.morphAttributes){let y=f.morphAttributes[m];for(let g=0,p=y.length;g<p;g++)t.remove(y[g])}f.removeEventListener("dispose",o),delete r[f.id];let d=s.get(f);d&&(t.remove(d),s.delete(f)),i.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,n.memory.geometries--}function a(h,f){return r[f.id]===!0||(f.addEventListener("dispose",o),r[f.id]=!0,n.memory.geometries++),f}function c(h){let f=h.attributes;for(let m in f)t.update(f[m],e.ARRAY_BUFFER);let d=h.morphAttributes;for(let m in d){let y=d[m];for(let g=0,p=y.length;g<p;g++)t.update(y[g],e.ARRAY_BUFFER)}}function l(h){let f=[],d=h.index,m=h.attributes.position,y=0;if(d!==null){let _=d.array;y=d.version;for(let b=0,x=_.length;b<x;b+=3){let C=_[b+0],w=_[b+1],S=_[b+2];f.push(C,w,w,S,S,C)}}else if(m!==void 0){let _=m.array;y=m.version;for(let b=0,x=_.length/3-1;b<x;b+=3){let C=b+0,w=b+1,S=b+2;f.push(C,w,w,S,S,C)}}else return;let g=new(kE(f)?bh:vh)(f,1);g.version=y;let p=s.get(h);p&&t.remove(p),s.set(h,g)}function u(h){let f=s.get(h);if(f){let d=h.index;d!==null&&f.version<d.version&&l(h)}else l(h);return s.get(h)}return{get:a,update:c,getWireframeAttribute:u}}function NO(e,t,n){let i;function r(f){i=f}let s,o;function a(f){s=f.type,o=f.bytesPerElement}function c(f,d){e.drawElements(i,d,s,f*o),n.update(d,i,1)}function l(f,d,m){m!==0&&(e.drawElementsInstanced(i,d,s,f*o,m),n.update(d,i,m))}function u(f,d,m){if(m===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,s,f,0,m);let g=0;for(let p=0;p<m;p++)g+=d[p];n.update(g,i,1)}function h(f,d,m,y){if(m===0)return;let g=t.get("WEBGL_multi_draw");if(g===null)for(let p=0;p<f.length;p++)l(f[p]/o,d[p],y[p]);else{g.multiDrawElementsInstancedWEBGL(i,d,0,s,f,0,y,0,m);let p=0;for(let _=0;_<m;_++)p+=d[_]*y[_];n.update(p,i,1)}}this.setMode=r,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function DO(e){let t={geometries:0,textures:0},n={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(n.calls++,o){case e.TRIANGLES:n.triangles+=a*(s/3);break;case e.LINES:n.lines+=a*(s/2);break;case e.LINE_STRIP:n.lines+=a*(s-1);break;case e.LINE_LOOP:n.lines+=a*s;break;case e.POINTS:n.points+=a*s;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function r(){n.calls=0,n.triangles=0,n.points=0,n.lines=0}return{memory:t,render:n,programs:null,autoReset:!0,reset:r,update:i}}function UO(e,t,n){let i=new WeakMap,r=new Ne;function s(o,a,c){let l=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let M=function(){S.dispose(),i.delete(a),a.removeEventListener("dispose",M)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],b=0;d===!0&&(b=1),m===!0&&(b=2),y===!0&&(b=3);let x=a.attributes.position.count*b,C=1;x>t.maxTextureSize&&(C=Math.ceil(x/t.maxTextureSize),x=t.maxTextureSize);let w=new Float32Array(x*C*4*h),S=new gh(w,x,C,h);S.type=Mr,S.needsUpdate=!0;let R=b*4;for(let v=0;v<h;v++){let E=g[v],N=p[v],U=_[v],F=x*C*4*v;for(let P=0;P<E.count;P++){let O=P*R;d===!0&&(r.fromBufferAttribute(E,P),w[F+O+0]=r.x,w[F+O+1]=r.y,w[F+O+2]=r.z,w[F+O+3]=0),m===!0&&(r.fromBufferAttribute(N,P),w[F+O+4]=r.x,w[F+O+5]=r.y,w[F+O+6]=r.z,w[F+O+7]=0),y===!0&&(r.fromBufferAttribute(U,P),w[F+O+8]=r.x,w[F+O+9]=r.y,w[F+O+10]=r.z,w[F+O+11]=U.itemSize===4?r.w:1)}}f={count:h,texture:S,size:new le(x,C)},i.set(a,f),a.addEventListener("dispose",M)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(e,"morphTexture",o.morphTexture,n);else{let d=0;for(let y=0;y<l.length;y++)d+=l[y];let m=a.morphTargetsRelative?1:1-d;c.getUniforms().setValue(e,"morphTargetBaseInfluence",m),c.getUniforms().setValue(e,"morphTargetInfluences",l)}c.getUniforms().setValue(e,"morphTargetsTexture",f.texture,n),c.getUniforms().setValue(e,"morphTargetsTextureSize",f.size)}return{update:s}}function FO(e,t,n,i){let r=new WeakMap;function s(c){let l=i.render.frame,u=c.geometry,h=t.get(c,u);if(r.get(h)!==l&&(t.update(h),r.set(h,l)),c.isInstancedMesh&&(c.hasEventListener("dispose",a)===!1&&c.addEventListener("dispose",a),r.get(c)!==l&&(n.update(c.instanceMatrix,e.ARRAY_BUFFER),c.instanceColor!==null&&n.update(c.instanceColor,e.ARRAY_BUFFER),r.set(c,l))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==l&&(f.update(),r.set(f,l))}return h}function o(){r=new WeakMap}function a(c){let l=c.target;l.removeEventListener("dispose",a),n.remove(l.instanceMatrix),l.instanceColor!==null&&n.remove(l.instanceColor)}return{update:s,dispose:o}}var Ah=class extends Nn{constructor(t,n,i,r,s,o,a,c,l,u=Pa){if(u!==Pa&&u!==Ba)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");i===void 0&&u===Pa&&(i=oo),i===void 0&&u===Ba&&(i=Oa),super(null,r,s,o,a,c,u,i,l),this.isDepthTexture=!0,this.image={width:t,height:n},this.magFilter=a!==void 0?a:Ln,this.minFilter=c!==void 0?c:Ln,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){let n=super.toJSON(t);return this.compareFunction!==null&&(n.compareFunction=this.compareFunction),n}},GE=new Nn,eE=new Ah(1,1),WE=new gh,$E=new Qy,XE=new wh,nE=[],iE=[],rE=new Float32Array(16),sE=new Float32Array(9),oE=new Float32Array(4);function Ga(e,t,n){let i=e[0];if(i<=0||i>0)return e;let r=t*n,s=nE[r];if(s===void 0&&(s=new Float32Array(r),nE[r]=s),t!==0){i.toArray(s,0);for(let o=1,a=0;o!==t;++o)a+=n,e[o].toArray(s,a)}return s}function ze(e,t){if(e.length!==t.length)return!1;for(let n=0,i=e.length;n<i;n++)if(e[n]!==t[n])return!1;return!0}function Ve(e,t){for(let n=0,i=t.length;n<i;n++)e[n]=t[n]}function Bh(e,t){let n=iE[t];n===void 0&&(n=new Int32Array(t),iE[t]=n);for(let i=0;i!==t;++i)n[i]=e.allocateTextureUnit();return n}function OO(e,t){let n=this.cache;n[0]!==t&&(e.uniform1f(this.addr,t),n[0]=t)}function BO(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2f(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(ze(n,t))return;e.uniform2fv(this.addr,t),Ve(n,t)}}function kO(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3f(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else if(t.r!==void 0)(n[0]!==t.r||n[1]!==t.g||n[2]!==t.b)&&(e.uniform3f(this.addr,t.r,t.g,t.b),n[0]=t.r,n[1]=t.g,n[2]=t.b);else{if(ze(n,t))return;e.uniform3fv(this.addr,t),Ve(n,t)}}function zO(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4f(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(ze(n,t))return;e.uniform4fv(this.addr,t),Ve(n,t)}}function VO(e,t){let n=this.cache,i=t.elements;if(i===void 0){if(ze(n,t))return;e.uniformMatrix2fv(this.addr,!1,t),Ve(n,t)}else{if(ze(n,i))return;oE.set(i),e.uniformMatrix2fv(this.addr,!1,oE),Ve(n,i)}}function HO(e,t){let n=this.cache,i=t.elements;if(i===void 0){if(ze(n,t))return;e.uniformMatrix3fv(this.addr,!1,t),Ve(n,t)}else{if(ze(n,i))return;sE.set(i),e.uniformMatrix3fv(this.addr,!1,sE),Ve(n,i)}}function GO(e,t){let n=this.cache,i=t.elements;if(i===void 0){if(ze(n,t))return;e.uniformMatrix4fv(this.addr,!1,t),Ve(n,t)}else{if(ze(n,i))return;rE.set(i),e.uniformMatrix4fv(this.addr,!1,rE),Ve(n,i)}}function WO(e,t){let n=this.cache;n[0]!==t&&(e.uniform1i(this.addr,t),n[0]=t)}function $O(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2i(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(ze(n,t))return;e.uniform2iv(this.addr,t),Ve(n,t)}}function XO(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3i(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else{if(ze(n,t))return;e.uniform3iv(this.addr,t),Ve(n,t)}}function YO(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4i(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(ze(n,t))return;e.uniform4iv(this.addr,t),Ve(n,t)}}function qO(e,t){let n=this.cache;n[0]!==t&&(e.uniform1ui(this.addr,t),n[0]=t)}function ZO(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2ui(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(ze(n,t))return;e.uniform2uiv(this.addr,t),Ve(n,t)}}function JO(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3ui(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else{if(ze(n,t))return;e.uniform3uiv(this.addr,t),Ve(n,t)}}function KO(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4ui(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(ze(n,t))return;e.uniform4uiv(this.addr,t),Ve(n,t)}}function jO(e,t,n){let i=this.cache,r=n.allocateTextureUnit();i[0]!==r&&(e.uniform1i(this.addr,r),i[0]=r);let s;this.type===e.SAMPLER_2D_SHADOW?(eE.compareFunction=BE,s=eE):s=GE,n.setTexture2D(t||s,r)}function QO(e,t,n){let i=this.cache,r=n.allocateTextureUnit();i[0]!==r&&(e.uniform1i(this.addr,r),i[0]=r),n.setTexture3D(t||$E,r)}function t6(e,t,n){let i=this.cache,r=n.allocateTextureUnit();i[0]!==r&&(e.uniform1i(this.addr,r),i[0]=r),n.setTextureCube(t||XE,r)}function e6(e,t,n){let i=this.cache,r=n.allocateTextureUnit();i[0]!==r&&(e.uniform1i(this.addr,r),i[0]=r),n.setTexture2DArray(t||WE,r)}function n6(e){switch(e){case 5126:return OO;case 35664:return BO;case 35665:return kO;case 35666:return zO;case 35674:return VO;case 35675:return HO;case 35676:return GO;case 5124:case 35670:return WO;case 35667:case 35671:return $O;case 35668:case 35672:return XO;case 35669:case 35673:return YO;case 5125:return qO;case 36294:return ZO;case 36295:return JO;case 36296:return KO;case 35678:case 36198:case 36298:case 36306:case 35682:return jO;case 35679:case 36299:case 36307:return QO;case 35680:case 36300:case 36308:case 36293:return t6;case 36289:case 36303:case 36311:case 36292:return e6}}function i6(e,t){e.uniform1fv(this.addr,t)}function r6(e,t){let n=Ga(t,this.size,2);e.uniform2fv(this.addr,n)}function s6(e,t){let n=Ga(t,this.size,3);e.uniform3fv(this.addr,n)}function o6(e,t){let n=Ga(t,this.size,4);e.uniform4fv(this.addr,n)}function a6(e,t){let n=Ga(t,this.size,4);e.uniformMatrix2fv(this.addr,!1,n)}function c6(e,t){let n=Ga(t,this.size,9);e.uniformMatrix3fv(this.addr,!1,n)}function l6(e,t){let n=Ga(t,this.size,16);e.uniformMatrix4fv(this.addr,!1,n)}function u6(e,t){e.uniform1iv(this.addr,t)}function f6(e,t){e.uniform2iv(this.addr,t)}function h6(e,t){e.uniform3iv(this.addr,t)}function d6(e,t){e.uniform4iv(this.addr,t)}function p6(e,t){e.uniform1uiv(this.addr,t)}function m6(e,t){e.uniform2uiv(this.addr,t)}function g6(e,t){e.uniform3uiv(this.addr,t)}function y6(e,t){e.uniform4uiv(this.addr,t)}function x6(e,t,n){let i=this.cache,r=t.length,s=Bh(n,r);ze(i,s)||(e.uniform1iv(this.addr,s),Ve(i,s));for(let o=0;o!==r;++o)n.setTexture2D(t[o]||GE,s[o])}function _6(e,t,n){let i=this.cache,r=t.length,s=Bh(n,r);ze(i,s)||(e.uniform1iv(this.addr,s),Ve(i,s));for(let o=0;o!==r;++o)n.setTexture3D(t[o]||$E,s[o])}function v6(e,t,n){let i=this.cache,r=t.length,s=Bh(n,r);ze(i,s)||(e.uniform1iv(this.addr,s),Ve(i,s));for(let o=0;o!==r;++o)n.setTextureCube(t[o]||XE,s[o])}function b6(e,t,n){let i=this.cache,r=t.length,s=Bh(n,r);ze(i,s)||(e.uniform1iv(this.addr,s),Ve(i,s));for(let o=0;o!==r;++o)n.setTexture2DArray(t[o]||WE,s[o])}function M6(e){switch(e){case 5126:return i6;case 35664:return r6;case 35665:return s6;case 35666:return o6;case 35674:return a6;case 35675:return c6;case 35676:return l6;case 5124:case 35670:return u6;case 35667:case 35671:return f6;case 35668:case 35672:return h6;case 35669:case 35673:return d6;case 5125:return p6;case 36294:return m6;case 36295:return g6;case 36296:return y6;case 35678:case 36198:case 36298:case 36306:case 35682:return x6;case 35679:case 36299:case 36307:return _6;case 35680:case 36300:case 36308:case 36293:return v6;case 36289:case 36303:case 36311:case 36292:return b6}}var ix=class{constructor(t,n,i){this.id=t,this.addr=i,this.cache=[],this.type=n.type,this.setValue=n6(n.type)}},rx=class{constructor(t,n,i){this.id=t,this.addr=i,this.cache=[],this.type=n.type,this.size=n.size,this.setValue=M6(n.type)}},sx=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,n,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(t,n[a.id],i)}}},cy=/(\w+)(\])?(\[|\.)?/g;function aE(e,t){e.seq.push(t),e.map[t.id]=t}function w6(e,t,n){let i=e.name,r=i.length;for(cy.lastIndex=0;;){let s=cy.exec(i),o=cy.lastIndex,a=s[1],c=s[2]==="]",l=s[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===r){aE(n,l===void 0?new ix(a,e,t):new rx(a,e,t));break}else{let h=n.map[a];h===void 0&&(h=new sx(a),aE(n,h)),n=h}}}var Na=class{constructor(t,n){this.seq=[],this.map={};let i=t.getProgramParameter(n,t.ACTIVE_UNIFORMS);for(let r=0;r<i;++r){let s=t.getActiveUniform(n,r),o=t.getUniformLocation(n,s.name);w6(s,o,this)}}setValue(t,n,i,r){let s=this.map[n];s!==void 0&&s.setValue(t,i,r)}setOptional(t,n,i){let r=n[i];r!==void 0&&this.setValue(t,i,r)}static upload(t,n,i,r){for(let s=0,o=n.length;s!==o;++s){let a=n[s],c=i[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,r)}}static seqWithValue(t,n){let i=[];for(let r=0,s=t.length;r!==s;++r){let o=t[r];o.id in n&&i.push(o)}return i}};function cE(e,t,n){let i=e.createShader(t);return e.shaderSource(i,n),e.compileShader(i),i}var S6=37297,T6=0;function E6(e,t){let n=e.split(`
`),i=[],r=Math.max(t-6,0),s=Math.min(t+6,n.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${n[o]}`)}return i.join(`
`)}var lE=new Wt;function A6(e){ee._getMatrix(lE,ee.workingColorSpace,e);let t=`mat3( ${lE.elements.map(n=>n.toFixed(4))} )`;switch(ee.getTransfer(e)){case Oh:return[t,"LinearTransferOETF"];case pe:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",e),[t,"LinearTransferOETF"]}}function uE(e,t,n){let i=e.getShaderParameter(t,e.COMPILE_STATUS),r=e.getShaderInfoLog(t).trim();if(i&&r==="")return"";let s=/ERROR: 0:(\d+)/.exec(r);if(s){let o=parseInt(s[1]);return n.toUpperCase()+`

`+r+`

`+E6(e.getShaderSource(t),o)}else return r}function C6(e,t){let n=A6(t);return[`vec4 ${e}( vec4 value ) {`,`	return ${n[1]}( vec4( value.rgb * ${n[0]}, value.a ) );`,"}"].join(`
`)}function R6(e,t){let n;switch(t){case QU:n="Linear";break;case t4:n="Reinhard";break;case e4:n="Cineon";break;case n4:n="ACESFilmic";break;case r4:n="AgX";break;case s4:n="Neutral";break;case i4:n="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),n="Linear"}return"vec3 "+e+"( vec3 color ) { return "+n+"ToneMapping( color ); }"}var th=new Y;function I6(){ee.getLuminanceCoefficients(th);let e=th.x.toFixed(4),t=th.y.toFixed(4),n=th.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${e}, ${t}, ${n} );`,"	return dot( weights, rgb );","}"].join(`
`)}function P6(e){return[e.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",e.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ul).join(`
`)}function L6(e){let t=[];for(let n in e){let i=e[n];i!==!1&&t.push("#define "+n+" "+i)}return t.join(`
`)}function N6(e,t){let n={},i=e.getProgramParameter(t,e.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=e.getActiveAttrib(t,r),o=s.name,a=1;s.type===e.FLOAT_MAT2&&(a=2),s.type===e.FLOAT_MAT3&&(a=3),s.type===e.FLOAT_MAT4&&(a=4),n[o]={type:s.type,location:e.getAttribLocation(t,o),locationSize:a}}return n}function ul(e){return e!==""}function fE(e,t){let n=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return e.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,n).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function hE(e,t){return e.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var D6=/^[ \t]*#include +<([\w\d./]+)>/gm;function ox(e){return e.replace(D6,F6)}var U6=new Map;function F6(e,t){let n=Yt[t];if(n===void 0){let i=U6.get(t);if(i!==void 0)n=Yt[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,i);else throw new Error("Can not resolve #include <"+t+">")}return ox(n)}var O6=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function dE(e){return e.replace(O6,B6)}function B6(e,t,n,i){let r="";for(let s=parseInt(t);s<parseInt(n);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function pE(e){let t=`precision ${e.precision} float;
	precision ${e.precision} int;
	precision ${e.precision} sampler2D;
	precision ${e.precision} samplerCube;
	precision ${e.precision} sampler3D;
	precision ${e.precision} sampler2DArray;
	precision ${e.precision} sampler2DShadow;
	precision ${e.precision} samplerCubeShadow;
	precision ${e.precision} sampler2DArrayShadow;
	precision ${e.precision} isampler2D;
	precision ${e.precision} isampler3D;
	precision ${e.precision} isamplerCube;
	precision ${e.precision} isampler2DArray;
	precision ${e.precision} usampler2D;
	precision ${e.precision} usampler3D;
	precision ${e.precision} usamplerCube;
	precision ${e.precision} usampler2DArray;
	`;return e.precision==="highp"?t+=`
#define HIGH_PRECISION`:e.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:e.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function k6(e){let t="SHADOWMAP_TYPE_BASIC";return e.shadowMapType===TE?t="SHADOWMAP_TYPE_PCF":e.shadowMapType===LU?t="SHADOWMAP_TYPE_PCF_SOFT":e.shadowMapType===_r&&(t="SHADOWMAP_TYPE_VSM"),t}function z6(e){let t="ENVMAP_TYPE_CUBE";if(e.envMap)switch(e.envMapMode){case Ua:case Fa:t="ENVMAP_TYPE_CUBE";break;case Fh:t="ENVMAP_TYPE_CUBE_UV";break}return t}function V6(e){let t="ENVMAP_MODE_REFLECTION";if(e.envMap)switch(e.envMapMode){case Fa:t="ENVMAP_MODE_REFRACTION";break}return t}function H6(e){let t="ENVMAP_BLENDING_NONE";if(e.envMap)switch(e.combine){case EE:t="ENVMAP_BLENDING_MULTIPLY";break;case KU:t="ENVMAP_BLENDING_MIX";break;case jU:t="ENVMAP_BLENDING_ADD";break}return t}function G6(e){let t=e.envMapCubeUVHeight;if(t===null)return null;let n=Math.log2(t)-2,i=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,n),7*16)),texelHeight:i,maxMip:n}}function W6(e,t,n,i){let r=e.getContext(),s=n.defines,o=n.vertexShader,a=n.fragmentShader,c=k6(n),l=z6(n),u=V6(n),h=H6(n),f=G6(n),d=P6(n),m=L6(s),y=r.createProgram(),g,p,_=n.glslVersion?"#version "+n.glslVersion+`
`:"";n.isRawShaderMaterial?(g=["#define SHADER_TYPE "+n.shaderType,"#define SHADER_NAME "+n.shaderName,m].filter(ul).join(`
`),g.length>0&&(g+=`
`),p=["#define SHADER_TYPE "+n.shaderType,"#define SHADER_NAME "+n.shaderName,m].filter(ul).join(`
`),p.length>0&&(p+=`
`)):(g=[pE(n),"#define SHADER_TYPE "+n.shaderType,"#define SHADER_NAME "+n.shaderName,m,n.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",n.batching?"#define USE_BATCHING":"",n.batchingColor?"#define USE_BATCHING_COLOR":"",n.instancing?"#define USE_INSTANCING":"",n.instancingColor?"#define USE_INSTANCING_COLOR":"",n.instancingMorph?"#define USE_INSTANCING_MORPH":"",n.useFog&&n.fog?"#define USE_FOG":"",n.useFog&&n.fogExp2?"#define FOG_EXP2":"",n.map?"#define USE_MAP":"",n.envMap?"#define USE_ENVMAP":"",n.envMap?"#define "+u:"",n.lightMap?"#define USE_LIGHTMAP":"",n.aoMap?"#define USE_AOMAP":"",n.bumpMap?"#define USE_BUMPMAP":"",n.normalMap?"#define USE_NORMALMAP":"",n.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",n.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",n.displacementMap?"#define USE_DISPLACEMENTMAP":"",n.emissiveMap?"#define USE_EMISSIVEMAP":"",n.anisotropy?"#define USE_ANISOTROPY":"",n.anisotropyMap?"#define USE_ANISOTROPYMAP":"",n.clearcoatMap?"#define USE_CLEARCOATMAP":"",n.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",n.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",n.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",n.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",n.specularMap?"#define USE_SPECULARMAP":"",n.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",n.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",n.roughnessMap?"#define USE_ROUGHNESSMAP":"",n.metalnessMap?"#define USE_METALNESSMAP":"",n.alphaMap?"#define USE_ALPHAMAP":"",n.alphaHash?"#define USE_ALPHAHASH":"",n.transmission?"#define USE_TRANSMISSION":"",n.transmissionMap?"#define USE_TRANSMISSIONMAP":"",n.thicknessMap?"#define USE_THICKNESSMAP":"",n.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",n.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",n.mapUv?"#define MAP_UV "+n.mapUv:"",n.alphaMapUv?"#define ALPHAMAP_UV "+n.alphaMapUv:"",n.lightMapUv?"#define LIGHTMAP_UV "+n.lightMapUv:"",n.aoMapUv?"#define AOMAP_UV "+n.aoMapUv:"",n.emissiveMapUv?"#define EMISSIVEMAP_UV "+n.emissiveMapUv:"",n.bumpMapUv?"#define BUMPMAP_UV "+n.bumpMapUv:"",n.normalMapUv?"#define NORMALMAP_UV "+n.normalMapUv:"",n.displacementMapUv?"#define DISPLACEMENTMAP_UV "+n.displacementMapUv:"",n.metalnessMapUv?"#define METALNESSMAP_UV "+n.metalnessMapUv:"",n.roughnessMapUv?"#define ROUGHNESSMAP_UV "+n.roughnessMapUv:"",n.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+n.anisotropyMapUv:"",n.clearcoatMapUv?"#define CLEARCOATMAP_UV "+n.clearcoatMapUv:"",n.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+n.clearcoatNormalMapUv:"",n.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+n.clearcoatRoughnessMapUv:"",n.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+n.iridescenceMapUv:"",n.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+n.iridescenceThicknessMapUv:"",n.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+n.sheenColorMapUv:"",n.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+n.sheenRoughnessMapUv:"",n.specularMapUv?"#define SPECULARMAP_UV "+n.specularMapUv:"",n.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+n.specularColorMapUv:"",n.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+n.specularIntensityMapUv:"",n.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+n.transmissionMapUv:"",n.thicknessMapUv?"#define THICKNESSMAP_UV "+n.thicknessMapUv:"",n.vertexTangents&&n.flatShading===!1?"#define USE_TANGENT":"",n.vertexColors?"#define USE_COLOR":"",n.vertexAlphas?"#define USE_COLOR_ALPHA":"",n.vertexUv1s?"#define USE_UV1":"",n.vertexUv2s?"#define USE_UV2":"",n.vertexUv3s?"#define USE_UV3":"",n.pointsUvs?"#define USE_POINTS_UV":"",n.flatShading?"#define FLAT_SHADED":"",n.skinning?"#define USE_SKINNING":"",n.morphTargets?"#define USE_MORPHTARGETS":"",n.morphNormals&&n.flatShading===!1?"#define USE_MORPHNORMALS":"",n.morphColors?"#define USE_MORPHCOLORS":"",n.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+n.morphTextureStride:"",n.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+n.morphTargetsCount:"",n.doubleSided?"#define DOUBLE_SIDED":"",n.flipSided?"#define FLIP_SIDED":"",n.shadowMapEnabled?"#define USE_SHADOWMAP":"",n.shadowMapEnabled?"#define "+c:"",n.sizeAttenuation?"#define USE_SIZEATTENUATION":"",n.numLightProbes>0?"#define USE_LIGHT_PROBES":"",n.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",n.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ul).join(`
`),p=[pE(n),"#define SHADER_TYPE "+n.shaderType,"#define SHADER_NAME "+n.shaderName,m,n.useFog&&n.fog?"#define USE_FOG":"",n.useFog&&n.fogExp2?"#define FOG_EXP2":"",n.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",n.map?"#define USE_MAP":"",n.matcap?"#define USE_MATCAP":"",n.envMap?"#define USE_ENVMAP":"",n.envMap?"#define "+l:"",n.envMap?"#define "+u:"",n.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",n.lightMap?"#define USE_LIGHTMAP":"",n.aoMap?"#define USE_AOMAP":"",n.bumpMap?"#define USE_BUMPMAP":"",n.normalMap?"#define USE_NORMALMAP":"",n.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",n.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",n.emissiveMap?"#define USE_EMISSIVEMAP":"",n.anisotropy?"#define USE_ANISOTROPY":"",n.anisotropyMap?"#define USE_ANISOTROPYMAP":"",n.clearcoat?"#define USE_CLEARCOAT":"",n.clearcoatMap?"#define USE_CLEARCOATMAP":"",n.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",n.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",n.dispersion?"#define USE_DISPERSION":"",n.iridescence?"#define USE_IRIDESCENCE":"",n.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",n.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",n.specularMap?"#define USE_SPECULARMAP":"",n.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",n.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",n.roughnessMap?"#define USE_ROUGHNESSMAP":"",n.metalnessMap?"#define USE_METALNESSMAP":"",n.alphaMap?"#define USE_ALPHAMAP":"",n.alphaTest?"#define USE_ALPHATEST":"",n.alphaHash?"#define USE_ALPHAHASH":"",n.sheen?"#define USE_SHEEN":"",n.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",n.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",n.transmission?"#define USE_TRANSMISSION":"",n.transmissionMap?"#define USE_TRANSMISSIONMAP":"",n.thicknessMap?"#define USE_THICKNESSMAP":"",n.vertexTangents&&n.flatShading===!1?"#define USE_TANGENT":"",n.vertexColors||n.instancingColor||n.batchingColor?"#define USE_COLOR":"",n.vertexAlphas?"#define USE_COLOR_ALPHA":"",n.vertexUv1s?"#define USE_UV1":"",n.vertexUv2s?"#define USE_UV2":"",n.vertexUv3s?"#define USE_UV3":"",n.pointsUvs?"#define USE_POINTS_UV":"",n.gradientMap?"#define USE_GRADIENTMAP":"",n.flatShading?"#define FLAT_SHADED":"",n.doubleSided?"#define DOUBLE_SIDED":"",n.flipSided?"#define FLIP_SIDED":"",n.shadowMapEnabled?"#define USE_SHADOWMAP":"",n.shadowMapEnabled?"#define "+c:"",n.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",n.numLightProbes>0?"#define USE_LIGHT_PROBES":"",n.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",n.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",n.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",n.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",n.toneMapping!==as?"#define TONE_MAPPING":"",n.toneMapping!==as?Yt.tonemapping_pars_fragment:"",n.toneMapping!==as?R6("toneMapping",n.toneMapping):"",n.dithering?"#define DITHERING":"",n.opaque?"#define OPAQUE":"",Yt.colorspace_pars_fragment,C6("linearToOutputTexel",n.outputColorSpace),I6(),n.useDepthPacking?"#define DEPTH_PACKING "+n.depthPacking:"",`
`].filter(ul).join(`
`)),o=ox(o),o=fE(o,n),o=hE(o,n),a=ox(a),a=fE(a,n),a=hE(a,n),o=dE(o),a=dE(a),n.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,g=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+g,p=["#define varying in",n.glslVersion===hh?"":"layout(location = 0) out highp vec4 pc_fragColor;",n.glslVersion===hh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let b=_+g+o,x=_+p+a,C=cE(r,r.VERTEX_SHADER,b),w=cE(r,r.FRAGMENT_SHADER,x);r.attachShader(y,C),r.attachShader(y,w),n.index0AttributeName!==void 0?r.bindAttribLocation(y,0,n.index0AttributeName):n.morphTargets===!0&&r.bindAttribLocation(y,0,"position"),r.linkProgram(y);function S(E){if(e.debug.checkShaderErrors){let N=r.getProgramInfoLog(y).trim(),U=r.getShaderInfoLog(C).trim(),F=r.getShaderInfoLog(w).trim(),P=!0,O=!0;if(r.getProgramParameter(y,r.LINK_STATUS)===!1)if(P=!1,typeof e.debug.onShaderError=="function")e.debug.onShaderError(r,y,C,w);else{let H=uE(r,C,"vertex"),z=uE(r,w,"fragment");console.error("THREE.WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(y,r.VALIDATE_STATUS)+`

Material Name: `+E.name+`
Material Type: `+E.type+`

Program Info Log: `+N+`
`+H+`
`+z)}else N!==""?console.warn("THREE.WebGLProgram: Program Info Log:",N):(U===""||F==="")&&(O=!1);O&&(E.diagnostics={runnable:P,programLog:N,vertexShader:{log:U,prefix:g},fragmentShader:{log:F,prefix:p}})}r.deleteShader(C),r.deleteShader(w),R=new Na(r,y),M=N6(r,y)}let R;this.getUniforms=function(){return R===void 0&&S(this),R};let M;this.getAttributes=function(){return M===void 0&&S(this),M};let v=n.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return v===!1&&(v=r.getProgramParameter(y,S6)),v},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(y),this.program=void 0},this.type=n.shaderType,this.name=n.shaderName,this.id=T6++,this.cacheKey=t,this.usedTimes=1,this.program=y,this.vertexShader=C,this.fragmentShader=w,this}var $6=0,ax=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){let n=t.vertexShader,i=t.fragmentShader,r=this._getShaderStage(n),s=this._getShaderStage(i),o=this._getShaderCacheForMaterial(t);return o.has(r)===!1&&(o.add(r),r.usedTimes++),o.has(s)===!1&&(o.add(s),s.usedTimes++),this}remove(t){let n=this.materialCache.get(t);for(let i of n)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let n=this.materialCache,i=n.get(t);return i===void 0&&(i=new Set,n.set(t,i)),i}_getShaderStage(t){let n=this.shaderCache,i=n.get(t);return i===void 0&&(i=new cx(t),n.set(t,i)),i}},cx=class{constructor(t){this.id=$6++,this.code=t,this.usedTimes=0}};function X6(e,t,n,i,r,s,o){let a=new yh,c=new ax,l=new Set,u=[],h=r.logarithmicDepthBuffer,f=r.vertexTextures,d=r.precision,m={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function y(M){return l.add(M),M===0?"uv":`uv${M}`}function g(M,v,E,N,U){let F=N.fog,P=U.geometry,O=M.isMeshStandardMaterial?N.environment:null,H=(M.isMeshStandardMaterial?n:t).get(M.envMap||O),z=H&&H.mapping===Fh?H.image.height:null,G=m[M.type];M.precision!==null&&(d=r.getMaxPrecision(M.precision),d!==M.precision&&console.warn("THREE.WebGLProgram.getParameters:",M.precision,"not supported, using",d,"instead."));let j=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,nt=j!==void 0?j.length:0,ct=0;P.morphAttributes.position!==void 0&&(ct=1),P.morphAttributes.normal!==void 0&&(ct=2),P.morphAttributes.color!==void 0&&(ct=3);let ft,$,tt,lt;if(G){let ae=Gi[G];ft=ae.vertexShader,$=ae.fragmentShader}else ft=M.vertexShader,$=M.fragmentShader,c.update(M),tt=c.getVertexShaderID(M),lt=c.getFragmentShaderID(M);let K=e.getRenderTarget(),ut=e.state.buffers.depth.getReversed(),q=U.isInstancedMesh===!0,ot=U.isBatchedMesh===!0,pt=!!M.map,X=!!M.matcap,Lt=!!H,L=!!M.aoMap,Ot=!!M.lightMap,St=!!M.bumpMap,Ut=!!M.normalMap,Tt=!!M.displacementMap,Qt=!!M.emissiveMap,Dt=!!M.metalnessMap,I=!!M.roughnessMap,T=M.anisotropy>0,W=M.clearcoat>0,rt=M.dispersion>0,at=M.iridescence>0,et=M.sheen>0,Et=M.transmission>0,mt=T&&!!M.anisotropyMap,Mt=W&&!!M.clearcoatMap,$t=W&&!!M.clearcoatNormalMap,ht=W&&!!M.clearcoatRoughnessMap,wt=at&&!!M.iridescenceMap,Nt=at&&!!M.iridescenceThicknessMap,It=et&&!!M.sheenColorMap,yt=et&&!!M.sheenRoughnessMap,Jt=!!M.specularMap,Xt=!!M.specularColorMap,ge=!!M.specularIntensityMap,B=Et&&!!M.transmissionMap,xt=Et&&!!M.thicknessMap,Q=!!M.gradientMap,st=!!M.alphaMap,bt=M.alphaTest>0,_t=!!M.alphaHash,Ht=!!M.extensions,Se=as;M.toneMapped&&(K===null||K.isXRRenderTarget===!0)&&(Se=e.toneMapping);let Qe={shaderID:G,shaderType:M.type,shaderName:M.name,vertexShader:ft,fragmentShader:$,defines:M.defines,customVertexShaderID:tt,customFragmentShaderID:lt,isRawShaderMaterial:M.isRawShaderMaterial===!0,glslVersion:M.glslVersion,precision:d,batching:ot,batchingColor:ot&&U._colorsTexture!==null,instancing:q,instancingColor:q&&U.instanceColor!==null,instancingMorph:q&&U.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:K===null?e.outputColorSpace:K.isXRRenderTarget===!0?K.texture.colorSpace:Ha,alphaToCoverage:!!M.alphaToCoverage,map:pt,matcap:X,envMap:Lt,envMapMode:Lt&&H.mapping,envMapCubeUVHeight:z,aoMap:L,lightMap:Ot,bumpMap:St,normalMap:Ut,displacementMap:f&&Tt,emissiveMap:Qt,normalMapObjectSpace:Ut&&M.normalMapType===u4,normalMapTangentSpace:Ut&&M.normalMapType===l4,metalnessMap:Dt,roughnessMap:I,anisotropy:T,anisotropyMap:mt,clearcoat:W,clearcoatMap:Mt,clearcoatNormalMap:$t,clearcoatRoughnessMap:ht,dispersion:rt,iridescence:at,iridescenceMap:wt,iridescenceThicknessMap:Nt,sheen:et,sheenColorMap:It,sheenRoughnessMap:yt,specularMap:Jt,specularColorMap:Xt,specularIntensityMap:ge,transmission:Et,transmissionMap:B,thicknessMap:xt,gradientMap:Q,opaque:M.transparent===!1&&M.blending===Ia&&M.alphaToCoverage===!1,alphaMap:st,alphaTest:bt,alphaHash:_t,combine:M.combine,mapUv:pt&&y(M.map.channel),aoMapUv:L&&y(M.aoMap.channel),lightMapUv:Ot&&y(M.lightMap.channel),bumpMapUv:St&&y(M.bumpMap.channel),normalMapUv:Ut&&y(M.normalMap.channel),displacementMapUv:Tt&&y(M.displacementMap.channel),emissiveMapUv:Qt&&y(M.emissiveMap.channel),metalnessMapUv:Dt&&y(M.metalnessMap.channel),roughnessMapUv:I&&y(M.roughnessMap.channel),anisotropyMapUv:mt&&y(M.anisotropyMap.channel),clearcoatMapUv:Mt&&y(M.clearcoatMap.channel),clearcoatNormalMapUv:$t&&y(M.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ht&&y(M.clearcoatRoughnessMap.channel),iridescenceMapUv:wt&&y(M.iridescenceMap.channel),iridescenceThicknessMapUv:Nt&&y(M.iridescenceThicknessMap.channel),sheenColorMapUv:It&&y(M.sheenColorMap.channel),sheenRoughnessMapUv:yt&&y(M.sheenRoughnessMap.channel),specularMapUv:Jt&&y(M.specularMap.channel),specularColorMapUv:Xt&&y(M.specularColorMap.channel),specularIntensityMapUv:ge&&y(M.specularIntensityMap.channel),transmissionMapUv:B&&y(M.transmissionMap.channel),thicknessMapUv:xt&&y(M.thicknessMap.channel),alphaMapUv:st&&y(M.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(Ut||T),vertexColors:M.vertexColors,vertexAlphas:M.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:U.isPoints===!0&&!!P.attributes.uv&&(pt||st),fog:!!F,useFog:M.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:M.flatShading===!0,sizeAttenuation:M.sizeAttenuation===!0,logarithmicDepthBuffer:h,reverseDepthBuffer:ut,skinning:U.isSkinnedMesh===!0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:nt,morphTextureStride:ct,numDirLights:v.directional.length,numPointLights:v.point.length,numSpotLights:v.spot.length,numSpotLightMaps:v.spotLightMap.length,numRectAreaLights:v.rectArea.length,numHemiLights:v.hemi.length,numDirLightShadows:v.directionalShadowMap.length,numPointLightShadows:v.pointShadowMap.length,numSpotLightShadows:v.spotShadowMap.length,numSpotLightShadowsWithMaps:v.numSpotLightShadowsWithMaps,numLightProbes:v.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:M.dithering,shadowMapEnabled:e.shadowMap.enabled&&E.length>0,shadowMapType:e.shadowMap.type,toneMapping:Se,decodeVideoTexture:pt&&M.map.isVideoTexture===!0&&ee.getTransfer(M.map.colorSpace)===pe,decodeVideoTextureEmissive:Qt&&M.emissiveMap.isVideoTexture===!0&&ee.getTransfer(M.emissiveMap.colorSpace)===pe,premultipliedAlpha:M.premultipliedAlpha,doubleSided:M.side===br,flipSided:M.side===Mn,useDepthPacking:M.depthPacking>=0,depthPacking:M.depthPacking||0,index0AttributeName:M.index0AttributeName,extensionClipCullDistance:Ht&&M.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ht&&M.extensions.multiDraw===!0||ot)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:M.customProgramCacheKey()};return Qe.vertexUv1s=l.has(1),Qe.vertexUv2s=l.has(2),Qe.vertexUv3s=l.has(3),l.clear(),Qe}function p(M){let v=[];if(M.shaderID?v.push(M.shaderID):(v.push(M.customVertexShaderID),v.push(M.customFragmentShaderID)),M.defines!==void 0)for(let E in M.defines)v.push(E),v.push(M.defines[E]);return M.isRawShaderMaterial===!1&&(_(v,M),b(v,M),v.push(e.outputColorSpace)),v.push(M.customProgramCacheKey),v.join()}function _(M,v){M.push(v.precision),M.push(v.outputColorSpace),M.push(v.envMapMode),M.push(v.envMapCubeUVHeight),M.push(v.mapUv),M.push(v.alphaMapUv),M.push(v.lightMapUv),M.push(v.aoMapUv),M.push(v.bumpMapUv),M.push(v.normalMapUv),M.push(v.displacementMapUv),M.push(v.emissiveMapUv),M.push(v.metalnessMapUv),M.push(v.roughnessMapUv),M.push(v.anisotropyMapUv),M.push(v.clearcoatMapUv),M.push(v.clearcoatNormalMapUv),M.push(v.clearcoatRoughnessMapUv),M.push(v.iridescenceMapUv),M.push(v.iridescenceThicknessMapUv),M.push(v.sheenColorMapUv),M.push(v.sheenRoughnessMapUv),M.push(v.specularMapUv),M.push(v.specularColorMapUv),M.push(v.specularIntensityMapUv),M.push(v.transmissionMapUv),M.push(v.thicknessMapUv),M.push(v.combine),M.push(v.fogExp2),M.push(v.sizeAttenuation),M.push(v.morphTargetsCount),M.push(v.morphAttributeCount),M.push(v.numDirLights),M.push(v.numPointLights),M.push(v.numSpotLights),M.push(v.numSpotLightMaps),M.push(v.numHemiLights),M.push(v.numRectAreaLights),M.push(v.numDirLightShadows),M.push(v.numPointLightShadows),M.push(v.numSpotLightShadows),M.push(v.numSpotLightShadowsWithMaps),M.push(v.numLightProbes),M.push(v.shadowMapType),M.push(v.toneMapping),M.push(v.numClippingPlanes),M.push(v.numClipIntersection),M.push(v.depthPacking)}function b(M,v){a.disableAll(),v.supportsVertexTextures&&a.enable(0),v.instancing&&a.enable(1),v.instancingColor&&a.enable(2),v.instancingMorph&&a.enable(3),v.matcap&&a.enable(4),v.envMap&&a.enable(5),v.normalMapObjectSpace&&a.enable(6),v.normalMapTangentSpace&&a.enable(7),v.clearcoat&&a.enable(8),v.iridescence&&a.enable(9),v.alphaTest&&a.enable(10),v.vertexColors&&a.enable(11),v.vertexAlphas&&a.enable(12),v.vertexUv1s&&a.enable(13),v.vertexUv2s&&a.enable(14),v.vertexUv3s&&a.enable(15),v.vertexTangents&&a.enable(16),v.anisotropy&&a.enable(17),v.alphaHash&&a.enable(18),v.batching&&a.enable(19),v.dispersion&&a.enable(20),v.batchingColor&&a.enable(21),M.push(a.mask),a.disableAll(),v.fog&&a.enable(0),v.useFog&&a.enable(1),v.flatShading&&a.enable(2),v.logarithmicDepthBuffer&&a.enable(3),v.reverseDepthBuffer&&a.enable(4),v.skinning&&a.enable(5),v.morphTargets&&a.enable(6),v.morphNormals&&a.enable(7),v.morphColors&&a.enable(8),v.premultipliedAlpha&&a.enable(9),v.shadowMapEnabled&&a.enable(10),v.doubleSided&&a.enable(11),v.flipSided&&a.enable(12),v.useDepthPacking&&a.enable(13),v.dithering&&a.enable(14),v.transmission&&a.enable(15),v.sheen&&a.enable(16),v.opaque&&a.enable(17),v.pointsUvs&&a.enable(18),v.decodeVideoTexture&&a.enable(19),v.decodeVideoTextureEmissive&&a.enable(20),v.alphaToCoverage&&a.enable(21),M.push(a.mask)}function x(M){let v=m[M.type],E;if(v){let N=Gi[v];E=F4.clone(N.uniforms)}else E=M.uniforms;return E}function C(M,v){let E;for(let N=0,U=u.length;N<U;N++){let F=u[N];if(F.cacheKey===v){E=F,++E.usedTimes;break}}return E===void 0&&(E=new W6(e,v,M,s),u.push(E)),E}function w(M){if(--M.usedTimes===0){let v=u.indexOf(M);u[v]=u[u.length-1],u.pop(),M.destroy()}}function S(M){c.remove(M)}function R(){c.dispose()}return{getParameters:g,getProgramCacheKey:p,getUniforms:x,acquireProgram:C,releaseProgram:w,releaseShaderCache:S,programs:u,dispose:R}}function Y6(){let e=new WeakMap;function t(o){return e.has(o)}function n(o){let a=e.get(o);return a===void 0&&(a={},e.set(o,a)),a}function i(o){e.delete(o)}function r(o,a,c){e.get(o)[a]=c}function s(){e=new WeakMap}return{has:t,get:n,remove:i,update:r,dispose:s}}function q6(e,t){return e.groupOrder!==t.groupOrder?e.groupOrder-t.groupOrder:e.renderOrder!==t.renderOrder?e.renderOrder-t.renderOrder:e.material.id!==t.material.id?e.material.id-t.material.id:e.z!==t.z?e.z-t.z:e.id-t.id}function mE(e,t){return e.groupOrder!==t.groupOrder?e.groupOrder-t.groupOrder:e.renderOrder!==t.renderOrder?e.renderOrder-t.renderOrder:e.z!==t.z?t.z-e.z:e.id-t.id}function gE(){let e=[],t=0,n=[],i=[],r=[];function s(){t=0,n.length=0,i.length=0,r.length=0}function o(h,f,d,m,y,g){let p=e[t];return p===void 0?(p={id:h.id,object:h,geometry:f,material:d,groupOrder:m,renderOrder:h.renderOrder,z:y,group:g},e[t]=p):(p.id=h.id,p.object=h,p.geometry=f,p.material=d,p.groupOrder=m,p.renderOrder=h.renderOrder,p.z=y,p.group=g),t++,p}function a(h,f,d,m,y,g){let p=o(h,f,d,m,y,g);d.transmission>0?i.push(p):d.transparent===!0?r.push(p):n.push(p)}function c(h,f,d,m,y,g){let p=o(h,f,d,m,y,g);d.transmission>0?i.unshift(p):d.transparent===!0?r.unshift(p):n.unshift(p)}function l(h,f){n.length>1&&n.sort(h||q6),i.length>1&&i.sort(f||mE),r.length>1&&r.sort(f||mE)}function u(){for(let h=t,f=e.length;h<f;h++){let d=e[h];if(d.id===null)break;d.id=null,d.object=null,d.geometry=null,d.material=null,d.group=null}}return{opaque:n,transmissive:i,transparent:r,init:s,push:a,unshift:c,finish:u,sort:l}}function Z6(){let e=new WeakMap;function t(i,r){let s=e.get(i),o;return s===void 0?(o=new gE,e.set(i,[o])):r>=s.length?(o=new gE,s.push(o)):o=s[r],o}function n(){e=new WeakMap}return{get:t,dispose:n}}function J6(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let n;switch(t.type){case"DirectionalLight":n={direction:new Y,color:new Kt};break;case"SpotLight":n={position:new Y,direction:new Y,color:new Kt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":n={position:new Y,color:new Kt,distance:0,decay:0};break;case"HemisphereLight":n={direction:new Y,skyColor:new Kt,groundColor:new Kt};break;case"RectAreaLight":n={color:new Kt,position:new Y,halfWidth:new Y,halfHeight:new Y};break}return e[t.id]=n,n}}}function K6(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let n;switch(t.type){case"DirectionalLight":n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new le};break;case"SpotLight":n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new le};break;case"PointLight":n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new le,shadowCameraNear:1,shadowCameraFar:1e3};break}return e[t.id]=n,n}}}var j6=0;function Q6(e,t){return(t.castShadow?2:0)-(e.castShadow?2:0)+(t.map?1:0)-(e.map?1:0)}function tB(e){let t=new J6,n=K6(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new Y);let r=new Y,s=new De,o=new De;function a(l){let u=0,h=0,f=0;for(let M=0;M<9;M++)i.probe[M].set(0,0,0);let d=0,m=0,y=0,g=0,p=0,_=0,b=0,x=0,C=0,w=0,S=0;l.sort(Q6);for(let M=0,v=l.length;M<v;M++){let E=l[M],N=E.color,U=E.intensity,F=E.distance,P=E.shadow&&E.shadow.map?E.shadow.map.texture:null;if(E.isAmbientLight)u+=N.r*U,h+=N.g*U,f+=N.b*U;else if(E.isLightProbe){for(let O=0;O<9;O++)i.probe[O].addScaledVector(E.sh.coefficients[O],U);S++}else if(E.isDirectionalLight){let O=t.get(E);if(O.color.copy(E.color).multiplyScalar(E.intensity),E.castShadow){let H=E.shadow,z=n.get(E);z.shadowIntensity=H.intensity,z.shadowBias=H.bias,z.shadowNormalBias=H.normalBias,z.shadowRadius=H.radius,z.shadowMapSize=H.mapSize,i.directionalShadow[d]=z,i.directionalShadowMap[d]=P,i.directionalShadowMatrix[d]=E.shadow.matrix,_++}i.directional[d]=O,d++}else if(E.isSpotLight){let O=t.get(E);O.position.setFromMatrixPosition(E.matrixWorld),O.color.copy(N).multiplyScalar(U),O.distance=F,O.coneCos=Math.cos(E.angle),O.penumbraCos=Math.cos(E.angle*(1-E.penumbra)),O.decay=E.decay,i.spot[y]=O;let H=E.shadow;if(E.map&&(i.spotLightMap[C]=E.map,C++,H.updateMatrices(E),E.castShadow&&w++),i.spotLightMatrix[y]=H.matrix,E.castShadow){let z=n.get(E);z.shadowIntensity=H.intensity,z.shadowBias=H.bias,z.shadowNormalBias=H.normalBias,z.shadowRadius=H.radius,z.shadowMapSize=H.mapSize,i.spotShadow[y]=z,i.spotShadowMap[y]=P,x++}y++}else if(E.isRectAreaLight){let O=t.get(E);O.color.copy(N).multiplyScalar(U),O.halfWidth.set(E.width*.5,0,0),O.halfHeight.set(0,E.height*.5,0),i.rectArea[g]=O,g++}else if(E.isPointLight){let O=t.get(E);if(O.color.copy(E.color).multiplyScalar(E.intensity),O.distance=E.distance,O.decay=E.decay,E.castShadow){let H=E.shadow,z=n.get(E);z.shadowIntensity=H.intensity,z.shadowBias=H.bias,z.shadowNormalBias=H.normalBias,z.shadowRadius=H.radius,z.shadowMapSize=H.mapSize,z.shadowCameraNear=H.camera.near,z.shadowCameraFar=H.camera.far,i.pointShadow[m]=z,i.pointShadowMap[m]=P,i.pointShadowMatrix[m]=E.shadow.matrix,b++}i.point[m]=O,m++}else if(E.isHemisphereLight){let O=t.get(E);O.skyColor.copy(E.color).multiplyScalar(U),O.groundColor.copy(E.groundColor).multiplyScalar(U),i.hemi[p]=O,p++}}g>0&&(e.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=gt.LTC_FLOAT_1,i.rectAreaLTC2=gt.LTC_FLOAT_2):(i.rectAreaLTC1=gt.LTC_HALF_1,i.rectAreaLTC2=gt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let R=i.hash;(R.directionalLength!==d||R.pointLength!==m||R.spotLength!==y||R.rectAreaLength!==g||R.hemiLength!==p||R.numDirectionalShadows!==_||R.numPointShadows!==b||R.numSpotShadows!==x||R.numSpotMaps!==C||R.numLightProbes!==S)&&(i.directional.length=d,i.spot.length=y,i.rectArea.length=g,i.point.length=m,i.hemi.length=p,i.directionalShadow.length=_,i.directionalShadowMap.length=_,i.pointShadow.length=b,i.pointShadowMap.length=b,i.spotShadow.length=x,i.spotShadowMap.length=x,i.directionalShadowMatrix.length=_,i.pointShadowMatrix.length=b,i.spotLightMatrix.length=x+C-w,i.spotLightMap.length=C,i.numSpotLightShadowsWithMaps=w,i.numLightProbes=S,R.directionalLength=d,R.pointLength=m,R.spotLength=y,R.rectAreaLength=g,R.hemiLength=p,R.numDirectionalShadows=_,R.numPointShadows=b,R.numSpotShadows=x,R.numSpotMaps=C,R.numLightProbes=S,i.version=j6++)}function c(l,u){let h=0,f=0,d=0,m=0,y=0,g=u.matrixWorldInverse;for(let p=0,_=l.length;p<_;p++){let b=l[p];if(b.isDirectionalLight){let x=i.directional[h];x.direction.setFromMatrixPosition(b.matrixWorld),r.setFromMatrixPosition(b.target.matrixWorld),x.direction.sub(r),x.direction.transformDirection(g),h++}else if(b.isSpotLight){let x=i.spot[d];x.position.setFromMatrixPosition(b.matrixWorld),x.position.applyMatrix4(g),x.direction.setFromMatrixPosition(b.matrixWorld),r.setFromMatrixPosition(b.target.matrixWorld),x.direction.sub(r),x.direction.transformDirection(g),d++}else if(b.isRectAreaLight){let x=i.rectArea[m];x.position.setFromMatrixPosition(b.matrixWorld),x.position.applyMatrix4(g),o.identity(),s.copy(b.matrixWorld),s.premultiply(g),o.extractRotation(s),x.halfWidth.set(b.width*.5,0,0),x.halfHeight.set(0,b.height*.5,0),x.halfWidth.applyMatrix4(o),x.halfHeight.applyMatrix4(o),m++}else if(b.isPointLight){let x=i.point[f];x.position.setFromMatrixPosition(b.matrixWorld),x.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let x=i.hemi[y];x.direction.setFromMatrixPosition(b.matrixWorld),x.direction.transformDirection(g),y++}}}return{setup:a,setupView:c,state:i}}function yE(e){let t=new tB(e),n=[],i=[];function r(u){l.camera=u,n.length=0,i.length=0}function s(u){n.push(u)}function o(u){i.push(u)}function a(){t.setup(n)}function c(u){t.setupView(n,u)}let l={lightsArray:n,shadowsArray:i,camera:null,lights:t,transmissionRenderTarget:{}};return{init:r,state:l,setupLights:a,setupLightsView:c,pushLight:s,pushShadow:o}}function eB(e){let t=new WeakMap;function n(r,s=0){let o=t.get(r),a;return o===void 0?(a=new yE(e),t.set(r,[a])):s>=o.length?(a=new yE(e),o.push(a)):a=o[s],a}function i(){t=new WeakMap}return{get:n,dispose:i}}var lx=class extends fs{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=a4,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},ux=class extends fs{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}},nB=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,iB=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function rB(e,t,n){let i=new Sh,r=new le,s=new le,o=new Ne,a=new lx({depthPacking:c4}),c=new ux,l={},u=n.maxTextureSize,h={[cs]:Mn,[Mn]:cs,[br]:br},f=new _i({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new le},radius:{value:4}},vertexShader:nB,fragmentShader:iB}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let m=new wn;m.setAttribute("position",new Ze(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new yi(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=TE;let p=this.type;this.render=function(w,S,R){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||w.length===0)return;let M=e.getRenderTarget(),v=e.getActiveCubeFace(),E=e.getActiveMipmapLevel(),N=e.state;N.setBlending(os),N.buffers.color.setClear(1,1,1,1),N.buffers.depth.setTest(!0),N.setScissorTest(!1);let U=p!==_r&&this.type===_r,F=p===_r&&this.type!==_r;for(let P=0,O=w.length;P<O;P++){let H=w[P],z=H.shadow;if(z===void 0){console.warn("THREE.WebGLShadowMap:",H,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;r.copy(z.mapSize);let G=z.getFrameExtents();if(r.multiply(G),s.copy(z.mapSize),(r.x>u||r.y>u)&&(r.x>u&&(s.x=Math.floor(u/G.x),r.x=s.x*G.x,z.mapSize.x=s.x),r.y>u&&(s.y=Math.floor(u/G.y),r.y=s.y*G.y,z.mapSize.y=s.y)),z.map===null||U===!0||F===!0){let nt=this.type!==_r?{minFilter:Ln,magFilter:Ln}:{};z.map!==null&&z.map.dispose(),z.map=new Er(r.x,r.y,nt),z.map.texture.name=H.name+".shadowMap",z.camera.updateProjectionMatrix()}e.setRenderTarget(z.map),e.clear();let j=z.getViewportCount();for(let nt=0;nt<j;nt++){let ct=z.getViewport(nt);o.set(s.x*ct.x,s.y*ct.y,s.x*ct.z,s.y*ct.w),N.viewport(o),z.updateMatrices(H,nt),i=z.getFrustum(),x(S,R,z.camera,H,this.type)}z.isPointLightShadow!==!0&&this.type===_r&&_(z,R),z.needsUpdate=!1}p=this.type,g.needsUpdate=!1,e.setRenderTarget(M,v,E)};function _(w,S){let R=t.update(y);f.defines.VSM_SAMPLES!==w.blurSamples&&(f.defines.VSM_SAMPLES=w.blurSamples,d.defines.VSM_SAMPLES=w.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),w.mapPass===null&&(w.mapPass=new Er(r.x,r.y)),f.uniforms.shadow_pass.value=w.map.texture,f.uniforms.resolution.value=w.mapSize,f.uniforms.radius.value=w.radius,e.setRenderTarget(w.mapPass),e.clear(),e.renderBufferDirect(S,null,R,f,y,null),d.uniforms.shadow_pass.value=w.mapPass.texture,d.uniforms.resolution.value=w.mapSize,d.uniforms.radius.value=w.radius,e.setRenderTarget(w.map),e.clear(),e.renderBufferDirect(S,null,R,d,y,null)}function b(w,S,R,M){let v=null,E=R.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(E!==void 0)v=E;else if(v=R.isPointLight===!0?c:a,e.localClippingEnabled&&S.clipShadows===!0&&Array.isArray(S.clippingPlanes)&&S.clippingPlanes.length!==0||S.displacementMap&&S.displacementScale!==0||S.alphaMap&&S.alphaTest>0||S.map&&S.alphaTest>0){let N=v.uuid,U=S.uuid,F=l[N];F===void 0&&(F={},l[N]=F);let P=F[U];P===void 0&&(P=v.clone(),F[U]=P,S.addEventListener("dispose",C)),v=P}if(v.visible=S.visible,v.wireframe=S.wireframe,M===_r?v.side=S.shadowSide!==null?S.shadowSide:S.side:v.side=S.shadowSide!==null?S.shadowSide:h[S.side],v.alphaMap=S.alphaMap,v.alphaTest=S.alphaTest,v.map=S.map,v.clipShadows=S.clipShadows,v.clippingPlanes=S.clippingPlanes,v.clipIntersection=S.clipIntersection,v.displacementMap=S.displacementMap,v.displacementScale=S.displacementScale,v.displacementBias=S.displacementBias,v.wireframeLinewidth=S.wireframeLinewidth,v.linewidth=S.linewidth,R.isPointLight===!0&&v.isMeshDistanceMaterial===!0){let N=e.properties.get(v);N.light=R}return v}function x(w,S,R,M,v){if(w.visible===!1)return;if(w.layers.test(S.layers)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&v===_r)&&(!w.frustumCulled||i.intersectsObject(w))){w.modelViewMatrix.multiplyMatrices(R.matrixWorldInverse,w.matrixWorld);let U=t.update(w),F=w.material;if(Array.isArray(F)){let P=U.groups;for(let O=0,H=P.length;O<H;O++){let z=P[O],G=F[z.materialIndex];if(G&&G.visible){let j=b(w,G,M,v);w.onBeforeShadow(e,w,S,R,U,j,z),e.renderBufferDirect(R,null,U,j,w,z),w.onAfterShadow(e,w,S,R,U,j,z)}}}else if(F.visible){let P=b(w,F,M,v);w.onBeforeShadow(e,w,S,R,U,P,null),e.renderBufferDirect(R,null,U,P,w,null),w.onAfterShadow(e,w,S,R,U,P,null)}}let N=w.children;for(let U=0,F=N.length;U<F;U++)x(N[U],S,R,M,v)}function C(w){w.target.removeEventListener("dispose",C);for(let R in l){let M=l[R],v=w.target.uuid;v in M&&(M[v].dispose(),delete M[v])}}}var sB={[hy]:dy,[py]:yy,[my]:xy,[Da]:gy,[dy]:hy,[yy]:py,[xy]:my,[gy]:Da};function oB(e,t){function n(){let B=!1,xt=new Ne,Q=null,st=new Ne(0,0,0,0);return{setMask:function(bt){Q!==bt&&!B&&(e.colorMask(bt,bt,bt,bt),Q=bt)},setLocked:function(bt){B=bt},setClear:function(bt,_t,Ht,Se,Qe){Qe===!0&&(bt*=Se,_t*=Se,Ht*=Se),xt.set(bt,_t,Ht,Se),st.equals(xt)===!1&&(e.clearColor(bt,_t,Ht,Se),st.copy(xt))},reset:function(){B=!1,Q=null,st.set(-1,0,0,0)}}}function i(){let B=!1,xt=!1,Q=null,st=null,bt=null;return{setReversed:function(_t){if(xt!==_t){let Ht=t.get("EXT_clip_control");xt?Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.ZERO_TO_ONE_EXT):Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.NEGATIVE_ONE_TO_ONE_EXT);let Se=bt;bt=null,this.setClear(Se)}xt=_t},getReversed:function(){return xt},setTest:function(_t){_t?K(e.DEPTH_TEST):ut(e.DEPTH_TEST)},setMask:function(_t){Q!==_t&&!B&&(e.depthMask(_t),Q=_t)},setFunc:function(_t){if(xt&&(_t=sB[_t]),st!==_t){switch(_t){case hy:e.depthFunc(e.NEVER);break;case dy:e.depthFunc(e.ALWAYS);break;case py:e.depthFunc(e.LESS);break;case Da:e.depthFunc(e.LEQUAL);break;case my:e.depthFunc(e.EQUAL);break;case gy:e.depthFunc(e.GEQUAL);break;case yy:e.depthFunc(e.GREATER);break;case xy:e.depthFunc(e.NOTEQUAL);break;default:e.depthFunc(e.LEQUAL)}st=_t}},setLocked:function(_t){B=_t},setClear:function(_t){bt!==_t&&(xt&&(_t=1-_t),e.clearDepth(_t),bt=_t)},reset:function(){B=!1,Q=null,st=null,bt=null,xt=!1}}}function r(){let B=!1,xt=null,Q=null,st=null,bt=null,_t=null,Ht=null,Se=null,Qe=null;return{setTest:function(ae){B||(ae?K(e.STENCIL_TEST):ut(e.STENCIL_TEST))},setMask:function(ae){xt!==ae&&!B&&(e.stencilMask(ae),xt=ae)},setFunc:function(ae,ei,$i){(Q!==ae||st!==ei||bt!==$i)&&(e.stencilFunc(ae,ei,$i),Q=ae,st=ei,bt=$i)},setOp:function(ae,ei,$i){(_t!==ae||Ht!==ei||Se!==$i)&&(e.stencilOp(ae,ei,$i),_t=ae,Ht=ei,Se=$i)},setLocked:function(ae){B=ae},setClear:function(ae){Qe!==ae&&(e.clearStencil(ae),Qe=ae)},reset:function(){B=!1,xt=null,Q=null,st=null,bt=null,_t=null,Ht=null,Se=null,Qe=null}}}let s=new n,o=new i,a=new r,c=new WeakMap,l=new WeakMap,u={},h={},f=new WeakMap,d=[],m=null,y=!1,g=null,p=null,_=null,b=null,x=null,C=null,w=null,S=new Kt(0,0,0),R=0,M=!1,v=null,E=null,N=null,U=null,F=null,P=e.getParameter(e.MAX_COMBINED_TEXTURE_IMAGE_UNITS),O=!1,H=0,z=e.getParameter(e.VERSION);z.indexOf("WebGL")!==-1?(H=parseFloat(/^WebGL (\d)/.exec(z)[1]),O=H>=1):z.indexOf("OpenGL ES")!==-1&&(H=parseFloat(/^OpenGL ES (\d)/.exec(z)[1]),O=H>=2);let G=null,j={},nt=e.getParameter(e.SCISSOR_BOX),ct=e.getParameter(e.VIEWPORT),ft=new Ne().fromArray(nt),$=new Ne().fromArray(ct);function tt(B,xt,Q,st){let bt=new Uint8Array(4),_t=e.createTexture();e.bindTexture(B,_t),e.texParameteri(B,e.TEXTURE_MIN_FILTER,e.NEAREST),e.texParameteri(B,e.TEXTURE_MAG_FILTER,e.NEAREST);for(let Ht=0;Ht<Q;Ht++)B===e.TEXTURE_3D||B===e.TEXTURE_2D_ARRAY?e.texImage3D(xt,0,e.RGBA,1,1,st,0,e.RGBA,e.UNSIGNED_BYTE,bt):e.texImage2D(xt+Ht,0,e.RGBA,1,1,0,e.RGBA,e.UNSIGNED_BYTE,bt);return _t}let lt={};lt[e.TEXTURE_2D]=tt(e.TEXTURE_2D,e.TEXTURE_2D,1),lt[e.TEXTURE_CUBE_MAP]=tt(e.TEXTURE_CUBE_MAP,e.TEXTURE_CUBE_MAP_POSITIVE_X,6),lt[e.TEXTURE_2D_ARRAY]=tt(e.TEXTURE_2D_ARRAY,e.TEXTURE_2D_ARRAY,1,1),lt[e.TEXTURE_3D]=tt(e.TEXTURE_3D,e.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),K(e.DEPTH_TEST),o.setFunc(Da),St(!1),Ut(vT),K(e.CULL_FACE),L(os);function K(B){u[B]!==!0&&(e.enable(B),u[B]=!0)}function ut(B){u[B]!==!1&&(e.disable(B),u[B]=!1)}function q(B,xt){return h[B]!==xt?(e.bindFramebuffer(B,xt),h[B]=xt,B===e.DRAW_FRAMEBUFFER&&(h[e.FRAMEBUFFER]=xt),B===e.FRAMEBUFFER&&(h[e.DRAW_FRAMEBUFFER]=xt),!0):!1}function ot(B,xt){let Q=d,st=!1;if(B){Q=f.get(xt),Q===void 0&&(Q=[],f.set(xt,Q));let bt=B.textures;if(Q.length!==bt.length||Q[0]!==e.COLOR_ATTACHMENT0){for(let _t=0,Ht=bt.length;_t<Ht;_t++)Q[_t]=e.COLOR_ATTACHMENT0+_t;Q.length=bt.length,st=!0}}else Q[0]!==e.BACK&&(Q[0]=e.BACK,st=!0);st&&e.drawBuffers(Q)}function pt(B){return m!==B?(e.useProgram(B),m=B,!0):!1}let X={[eo]:e.FUNC_ADD,[DU]:e.FUNC_SUBTRACT,[UU]:e.FUNC_REVERSE_SUBTRACT};X[FU]=e.MIN,X[OU]=e.MAX;let Lt={[BU]:e.ZERO,[kU]:e.ONE,[zU]:e.SRC_COLOR,[uy]:e.SRC_ALPHA,[XU]:e.SRC_ALPHA_SATURATE,[WU]:e.DST_COLOR,[HU]:e.DST_ALPHA,[VU]:e.ONE_MINUS_SRC_COLOR,[fy]:e.ONE_MINUS_SRC_ALPHA,[$U]:e.ONE_MINUS_DST_COLOR,[GU]:e.ONE_MINUS_DST_ALPHA,[YU]:e.CONSTANT_COLOR,[qU]:e.ONE_MINUS_CONSTANT_COLOR,[ZU]:e.CONSTANT_ALPHA,[JU]:e.ONE_MINUS_CONSTANT_ALPHA};function L(B,xt,Q,st,bt,_t,Ht,Se,Qe,ae){if(B===os){y===!0&&(ut(e.BLEND),y=!1);return}if(y===!1&&(K(e.BLEND),y=!0),B!==NU){if(B!==g||ae!==M){if((p!==eo||x!==eo)&&(e.blendEquation(e.FUNC_ADD),p=eo,x=eo),ae)switch(B){case Ia:e.blendFuncSeparate(e.ONE,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case bT:e.blendFunc(e.ONE,e.ONE);break;case MT:e.blendFuncSeparate(e.ZERO,e.ONE_MINUS_SRC_COLOR,e.ZERO,e.ONE);break;case wT:e.blendFuncSeparate(e.ZERO,e.SRC_COLOR,e.ZERO,e.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",B);break}else switch(B){case Ia:e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case bT:e.blendFunc(e.SRC_ALPHA,e.ONE);break;case MT:e.blendFuncSeparate(e.ZERO,e.ONE_MINUS_SRC_COLOR,e.ZERO,e.ONE);break;case wT:e.blendFunc(e.ZERO,e.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",B);break}_=null,b=null,C=null,w=null,S.set(0,0,0),R=0,g=B,M=ae}return}bt=bt||xt,_t=_t||Q,Ht=Ht||st,(xt!==p||bt!==x)&&(e.blendEquationSeparate(X[xt],X[bt]),p=xt,x=bt),(Q!==_||st!==b||_t!==C||Ht!==w)&&(e.blendFuncSeparate(Lt[Q],Lt[st],Lt[_t],Lt[Ht]),_=Q,b=st,C=_t,w=Ht),(Se.equals(S)===!1||Qe!==R)&&(e.blendColor(Se.r,Se.g,Se.b,Qe),S.copy(Se),R=Qe),g=B,M=!1}function Ot(B,xt){B.side===br?ut(e.CULL_FACE):K(e.CULL_FACE);let Q=B.side===Mn;xt&&(Q=!Q),St(Q),B.blending===Ia&&B.transparent===!1?L(os):L(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),s.setMask(B.colorWrite);let st=B.stencilWrite;a.setTest(st),st&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),Qt(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?K(e.SAMPLE_ALPHA_TO_COVERAGE):ut(e.SAMPLE_ALPHA_TO_COVERAGE)}function St(B){v!==B&&(B?e.frontFace(e.CW):e.frontFace(e.CCW),v=B)}function Ut(B){B!==IU?(K(e.CULL_FACE),B!==E&&(B===vT?e.cullFace(e.BACK):B===PU?e.cullFace(e.FRONT):e.cullFace(e.FRONT_AND_BACK))):ut(e.CULL_FACE),E=B}function Tt(B){B!==N&&(O&&e.lineWidth(B),N=B)}function Qt(B,xt,Q){B?(K(e.POLYGON_OFFSET_FILL),(U!==xt||F!==Q)&&(e.polygonOffset(xt,Q),U=xt,F=Q)):ut(e.POLYGON_OFFSET_FILL)}function Dt(B){B?K(e.SCISSOR_TEST):ut(e.SCISSOR_TEST)}function I(B){B===void 0&&(B=e.TEXTURE0+P-1),G!==B&&(e.activeTexture(B),G=B)}function T(B,xt,Q){Q===void 0&&(G===null?Q=e.TEXTURE0+P-1:Q=G);let st=j[Q];st===void 0&&(st={type:void 0,texture:void 0},j[Q]=st),(st.type!==B||st.texture!==xt)&&(G!==Q&&(e.activeTexture(Q),G=Q),e.bindTexture(B,xt||lt[B]),st.type=B,st.texture=xt)}function W(){let B=j[G];B!==void 0&&B.type!==void 0&&(e.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function rt(){try{e.compressedTexImage2D.apply(e,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function at(){try{e.compressedTexImage3D.apply(e,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function et(){try{e.texSubImage2D.apply(e,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Et(){try{e.texSubImage3D.apply(e,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function mt(){try{e.compressedTexSubImage2D.apply(e,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Mt(){try{e.compressedTexSubImage3D.apply(e,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function $t(){try{e.texStorage2D.apply(e,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function ht(){try{e.texStorage3D.apply(e,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function wt(){try{e.texImage2D.apply(e,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Nt(){try{e.texImage3D.apply(e,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function It(B){ft.equals(B)===!1&&(e.scissor(B.x,B.y,B.z,B.w),ft.copy(B))}function yt(B){$.equals(B)===!1&&(e.viewport(B.x,B.y,B.z,B.w),$.copy(B))}function Jt(B,xt){let Q=l.get(xt);Q===void 0&&(Q=new WeakMap,l.set(xt,Q));let st=Q.get(B);st===void 0&&(st=e.getUniformBlockIndex(xt,B.name),Q.set(B,st))}function Xt(B,xt){let st=l.get(xt).get(B);c.get(xt)!==st&&(e.uniformBlockBinding(xt,st,B.__bindingPointIndex),c.set(xt,st))}function ge(){e.disable(e.BLEND),e.disable(e.CULL_FACE),e.disable(e.DEPTH_TEST),e.disable(e.POLYGON_OFFSET_FILL),e.disable(e.SCISSOR_TEST),e.disable(e.STENCIL_TEST),e.disable(e.SAMPLE_ALPHA_TO_COVERAGE),e.blendEquation(e.FUNC_ADD),e.blendFunc(e.ONE,e.ZERO),e.blendFuncSeparate(e.ONE,e.ZERO,e.ONE,e.ZERO),e.blendColor(0,0,0,0),e.colorMask(!0,!0,!0,!0),e.clearColor(0,0,0,0),e.depthMask(!0),e.depthFunc(e.LESS),o.setReversed(!1),e.clearDepth(1),e.stencilMask(4294967295),e.stencilFunc(e.ALWAYS,0,4294967295),e.stencilOp(e.KEEP,e.KEEP,e.KEEP),e.clearStencil(0),e.cullFace(e.BACK),e.frontFace(e.CCW),e.polygonOffset(0,0),e.activeTexture(e.TEXTURE0),e.bindFramebuffer(e.FRAMEBUFFER,null),e.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),e.bindFramebuffer(e.READ_FRAMEBUFFER,null),e.useProgram(null),e.lineWidth(1),e.scissor(0,0,e.canvas.width,e.canvas.height),e.viewport(0,0,e.canvas.width,e.canvas.height),u={},G=null,j={},h={},f=new WeakMap,d=[],m=null,y=!1,g=null,p=null,_=null,b=null,x=null,C=null,w=null,S=new Kt(0,0,0),R=0,M=!1,v=null,E=null,N=null,U=null,F=null,ft.set(0,0,e.canvas.width,e.canvas.height),$.set(0,0,e.canvas.width,e.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:K,disable:ut,bindFramebuffer:q,drawBuffers:ot,useProgram:pt,setBlending:L,setMaterial:Ot,setFlipSided:St,setCullFace:Ut,setLineWidth:Tt,setPolygonOffset:Qt,setScissorTest:Dt,activeTexture:I,bindTexture:T,unbindTexture:W,compressedTexImage2D:rt,compressedTexImage3D:at,texImage2D:wt,texImage3D:Nt,updateUBOMapping:Jt,uniformBlockBinding:Xt,texStorage2D:$t,texStorage3D:ht,texSubImage2D:et,texSubImage3D:Et,compressedTexSubImage2D:mt,compressedTexSubImage3D:Mt,scissor:It,viewport:yt,reset:ge}}function xE(e,t,n,i){let r=aB(i);switch(n){case PE:return e*t;case NE:return e*t;case DE:return e*t*2;case UE:return e*t/r.components*r.byteLength;case Px:return e*t/r.components*r.byteLength;case FE:return e*t*2/r.components*r.byteLength;case Lx:return e*t*2/r.components*r.byteLength;case LE:return e*t*3/r.components*r.byteLength;case Pn:return e*t*4/r.components*r.byteLength;case Nx:return e*t*4/r.components*r.byteLength;case oh:case ah:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*8;case ch:case lh:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case Sy:case Ey:return Math.max(e,16)*Math.max(t,8)/4;case wy:case Ty:return Math.max(e,8)*Math.max(t,8)/2;case Ay:case Cy:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*8;case Ry:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case Iy:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case Py:return Math.floor((e+4)/5)*Math.floor((t+3)/4)*16;case Ly:return Math.floor((e+4)/5)*Math.floor((t+4)/5)*16;case Ny:return Math.floor((e+5)/6)*Math.floor((t+4)/5)*16;case Dy:return Math.floor((e+5)/6)*Math.floor((t+5)/6)*16;case Uy:return Math.floor((e+7)/8)*Math.floor((t+4)/5)*16;case Fy:return Math.floor((e+7)/8)*Math.floor((t+5)/6)*16;case Oy:return Math.floor((e+7)/8)*Math.floor((t+7)/8)*16;case By:return Math.floor((e+9)/10)*Math.floor((t+4)/5)*16;case ky:return Math.floor((e+9)/10)*Math.floor((t+5)/6)*16;case zy:return Math.floor((e+9)/10)*Math.floor((t+7)/8)*16;case Vy:return Math.floor((e+9)/10)*Math.floor((t+9)/10)*16;case Hy:return Math.floor((e+11)/12)*Math.floor((t+9)/10)*16;case Gy:return Math.floor((e+11)/12)*Math.floor((t+11)/12)*16;case uh:case Wy:case $y:return Math.ceil(e/4)*Math.ceil(t/4)*16;case OE:case Xy:return Math.ceil(e/4)*Math.ceil(t/4)*8;case Yy:case qy:return Math.ceil(e/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${n} format.`)}function aB(e){switch(e){case Tr:case CE:return{byteLength:1,components:1};case hl:case RE:case gl:return{byteLength:2,components:1};case Rx:case Ix:return{byteLength:2,components:4};case oo:case Cx:case Mr:return{byteLength:4,components:1};case IE:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${e}.`)}function cB(e,t,n,i,r,s,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new le,u=new WeakMap,h,f=new WeakMap,d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(I,T){return d?new OffscreenCanvas(I,T):ph("canvas")}function y(I,T,W){let rt=1,at=Dt(I);if((at.width>W||at.height>W)&&(rt=W/Math.max(at.width,at.height)),rt<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let et=Math.floor(rt*at.width),Et=Math.floor(rt*at.height);h===void 0&&(h=m(et,Et));let mt=T?m(et,Et):h;return mt.width=et,mt.height=Et,mt.getContext("2d").drawImage(I,0,0,et,Et),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+et+"x"+Et+")."),mt}else return"data"in I&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),I;return I}function g(I){return I.generateMipmaps}function p(I){e.generateMipmap(I)}function _(I){return I.isWebGLCubeRenderTarget?e.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?e.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?e.TEXTURE_2D_ARRAY:e.TEXTURE_2D}function b(I,T,W,rt,at=!1){if(I!==null){if(e[I]!==void 0)return e[I];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let et=T;if(T===e.RED&&(W===e.FLOAT&&(et=e.R32F),W===e.HALF_FLOAT&&(et=e.R16F),W===e.UNSIGNED_BYTE&&(et=e.R8)),T===e.RED_INTEGER&&(W===e.UNSIGNED_BYTE&&(et=e.R8UI),W===e.UNSIGNED_SHORT&&(et=e.R16UI),W===e.UNSIGNED_INT&&(et=e.R32UI),W===e.BYTE&&(et=e.R8I),W===e.SHORT&&(et=e.R16I),W===e.INT&&(et=e.R32I)),T===e.RG&&(W===e.FLOAT&&(et=e.RG32F),W===e.HALF_FLOAT&&(et=e.RG16F),W===e.UNSIGNED_BYTE&&(et=e.RG8)),T===e.RG_INTEGER&&(W===e.UNSIGNED_BYTE&&(et=e.RG8UI),W===e.UNSIGNED_SHORT&&(et=e.RG16UI),W===e.UNSIGNED_INT&&(et=e.RG32UI),W===e.BYTE&&(et=e.RG8I),W===e.SHORT&&(et=e.RG16I),W===e.INT&&(et=e.RG32I)),T===e.RGB_INTEGER&&(W===e.UNSIGNED_BYTE&&(et=e.RGB8UI),W===e.UNSIGNED_SHORT&&(et=e.RGB16UI),W===e.UNSIGNED_INT&&(et=e.RGB32UI),W===e.BYTE&&(et=e.RGB8I),W===e.SHORT&&(et=e.RGB16I),W===e.INT&&(et=e.RGB32I)),T===e.RGBA_INTEGER&&(W===e.UNSIGNED_BYTE&&(et=e.RGBA8UI),W===e.UNSIGNED_SHORT&&(et=e.RGBA16UI),W===e.UNSIGNED_INT&&(et=e.RGBA32UI),W===e.BYTE&&(et=e.RGBA8I),W===e.SHORT&&(et=e.RGBA16I),W===e.INT&&(et=e.RGBA32I)),T===e.RGB&&W===e.UNSIGNED_INT_5_9_9_9_REV&&(et=e.RGB9_E5),T===e.RGBA){let Et=at?Oh:ee.getTransfer(rt);W===e.FLOAT&&(et=e.RGBA32F),W===e.HALF_FLOAT&&(et=e.RGBA16F),W===e.UNSIGNED_BYTE&&(et=Et===pe?e.SRGB8_ALPHA8:e.RGBA8),W===e.UNSIGNED_SHORT_4_4_4_4&&(et=e.RGBA4),W===e.UNSIGNED_SHORT_5_5_5_1&&(et=e.RGB5_A1)}return(et===e.R16F||et===e.R32F||et===e.RG16F||et===e.RG32F||et===e.RGBA16F||et===e.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function x(I,T){let W;return I?T===null||T===oo||T===Oa?W=e.DEPTH24_STENCIL8:T===Mr?W=e.DEPTH32F_STENCIL8:T===hl&&(W=e.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===oo||T===Oa?W=e.DEPTH_COMPONENT24:T===Mr?W=e.DEPTH_COMPONENT32F:T===hl&&(W=e.DEPTH_COMPONENT16),W}function C(I,T){return g(I)===!0||I.isFramebufferTexture&&I.minFilter!==Ln&&I.minFilter!==Wi?Math.log2(Math.max(T.width,T.height))+1:I.mipmaps!==void 0&&I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?T.mipmaps.length:1}function w(I){let T=I.target;T.removeEventListener("dispose",w),R(T),T.isVideoTexture&&u.delete(T)}function S(I){let T=I.target;T.removeEventListener("dispose",S),v(T)}function R(I){let T=i.get(I);if(T.__webglInit===void 0)return;let W=I.source,rt=f.get(W);if(rt){let at=rt[T.__cacheKey];at.usedTimes--,at.usedTimes===0&&M(I),Object.keys(rt).length===0&&f.delete(W)}i.remove(I)}function M(I){let T=i.get(I);e.deleteTexture(T.__webglTexture);let W=I.source,rt=f.get(W);delete rt[T.__cacheKey],o.memory.textures--}function v(I){let T=i.get(I);if(I.depthTexture&&(I.depthTexture.dispose(),i.remove(I.depthTexture)),I.isWebGLCubeRenderTarget)for(let rt=0;rt<6;rt++){if(Array.isArray(T.__webglFramebuffer[rt]))for(let at=0;at<T.__webglFramebuffer[rt].length;at++)e.deleteFramebuffer(T.__webglFramebuffer[rt][at]);else e.deleteFramebuffer(T.__webglFramebuffer[rt]);T.__webglDepthbuffer&&e.deleteRenderbuffer(T.__webglDepthbuffer[rt])}else{if(Array.isArray(T.__webglFramebuffer))for(let rt=0;rt<T.__webglFramebuffer.length;rt++)e.deleteFramebuffer(T.__webglFramebuffer[rt]);else e.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&e.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&e.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let rt=0;rt<T.__webglColorRenderbuffer.length;rt++)T.__webglColorRenderbuffer[rt]&&e.deleteRenderbuffer(T.__webglColorRenderbuffer[rt]);T.__webglDepthRenderbuffer&&e.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let W=I.textures;for(let rt=0,at=W.length;rt<at;rt++){let et=i.get(W[rt]);et.__webglTexture&&(e.deleteTexture(et.__webglTexture),o.memory.textures--),i.remove(W[rt])}i.remove(I)}let E=0;function N(){E=0}function U(){let I=E;return I>=r.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+I+" texture units while this GPU supports only "+r.maxTextures),E+=1,I}function F(I){let T=[];return T.push(I.wrapS),T.push(I.wrapT),T.push(I.wrapR||0),T.push(I.magFilter),T.push(I.minFilter),T.push(I.anisotropy),T.push(I.internalFormat),T.push(I.format),T.push(I.type),T.push(I.generateMipmaps),T.push(I.premultiplyAlpha),T.push(I.flipY),T.push(I.unpackAlignment),T.push(I.colorSpace),T.join()}function P(I,T){let W=i.get(I);if(I.isVideoTexture&&Tt(I),I.isRenderTargetTexture===!1&&I.version>0&&W.__version!==I.version){let rt=I.image;if(rt===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(rt.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{$(W,I,T);return}}n.bindTexture(e.TEXTURE_2D,W.__webglTexture,e.TEXTURE0+T)}function O(I,T){let W=i.get(I);if(I.version>0&&W.__version!==I.version){$(W,I,T);return}n.bindTexture(e.TEXTURE_2D_ARRAY,W.__webglTexture,e.TEXTURE0+T)}function H(I,T){let W=i.get(I);if(I.version>0&&W.__version!==I.version){$(W,I,T);return}n.bindTexture(e.TEXTURE_3D,W.__webglTexture,e.TEXTURE0+T)}function z(I,T){let W=i.get(I);if(I.version>0&&W.__version!==I.version){tt(W,I,T);return}n.bindTexture(e.TEXTURE_CUBE_MAP,W.__webglTexture,e.TEXTURE0+T)}let G={[by]:e.REPEAT,[ro]:e.CLAMP_TO_EDGE,[My]:e.MIRRORED_REPEAT},j={[Ln]:e.NEAREST,[o4]:e.NEAREST_MIPMAP_NEAREST,[Df]:e.NEAREST_MIPMAP_LINEAR,[Wi]:e.LINEAR,[N0]:e.LINEAR_MIPMAP_NEAREST,[so]:e.LINEAR_MIPMAP_LINEAR},nt={[f4]:e.NEVER,[y4]:e.ALWAYS,[h4]:e.LESS,[BE]:e.LEQUAL,[d4]:e.EQUAL,[g4]:e.GEQUAL,[p4]:e.GREATER,[m4]:e.NOTEQUAL};function ct(I,T){if(T.type===Mr&&t.has("OES_texture_float_linear")===!1&&(T.magFilter===Wi||T.magFilter===N0||T.magFilter===Df||T.magFilter===so||T.minFilter===Wi||T.minFilter===N0||T.minFilter===Df||T.minFilter===so)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),e.texParameteri(I,e.TEXTURE_WRAP_S,G[T.wrapS]),e.texParameteri(I,e.TEXTURE_WRAP_T,G[T.wrapT]),(I===e.TEXTURE_3D||I===e.TEXTURE_2D_ARRAY)&&e.texParameteri(I,e.TEXTURE_WRAP_R,G[T.wrapR]),e.texParameteri(I,e.TEXTURE_MAG_FILTER,j[T.magFilter]),e.texParameteri(I,e.TEXTURE_MIN_FILTER,j[T.minFilter]),T.compareFunction&&(e.texParameteri(I,e.TEXTURE_COMPARE_MODE,e.COMPARE_REF_TO_TEXTURE),e.texParameteri(I,e.TEXTURE_COMPARE_FUNC,nt[T.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===Ln||T.minFilter!==Df&&T.minFilter!==so||T.type===Mr&&t.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||i.get(T).__currentAnisotropy){let W=t.get("EXT_texture_filter_anisotropic");e.texParameterf(I,W.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,r.getMaxAnisotropy())),i.get(T).__currentAnisotropy=T.anisotropy}}}function ft(I,T){let W=!1;I.__webglInit===void 0&&(I.__webglInit=!0,T.addEventListener("dispose",w));let rt=T.source,at=f.get(rt);at===void 0&&(at={},f.set(rt,at));let et=F(T);if(et!==I.__cacheKey){at[et]===void 0&&(at[et]={texture:e.createTexture(),usedTimes:0},o.memory.textures++,W=!0),at[et].usedTimes++;let Et=at[I.__cacheKey];Et!==void 0&&(at[I.__cacheKey].usedTimes--,Et.usedTimes===0&&M(T)),I.__cacheKey=et,I.__webglTexture=at[et].texture}return W}function $(I,T,W){let rt=e.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(rt=e.TEXTURE_2D_ARRAY),T.isData3DTexture&&(rt=e.TEXTURE_3D);let at=ft(I,T),et=T.source;n.bindTexture(rt,I.__webglTexture,e.TEXTURE0+W);let Et=i.get(et);if(et.version!==Et.__version||at===!0){n.activeTexture(e.TEXTURE0+W);let mt=ee.getPrimaries(ee.workingColorSpace),Mt=T.colorSpace===rs?null:ee.getPrimaries(T.colorSpace),$t=T.colorSpace===rs||mt===Mt?e.NONE:e.BROWSER_DEFAULT_WEBGL;e.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(e.UNPACK_ALIGNMENT,T.unpackAlignment),e.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,$t);let ht=y(T.image,!1,r.maxTextureSize);ht=Qt(T,ht);let wt=s.convert(T.format,T.colorSpace),Nt=s.convert(T.type),It=b(T.internalFormat,wt,Nt,T.colorSpace,T.isVideoTexture);ct(rt,T);let yt,Jt=T.mipmaps,Xt=T.isVideoTexture!==!0,ge=Et.__version===void 0||at===!0,B=et.dataReady,xt=C(T,ht);if(T.isDepthTexture)It=x(T.format===Ba,T.type),ge&&(Xt?n.texStorage2D(e.TEXTURE_2D,1,It,ht.width,ht.height):n.texImage2D(e.TEXTURE_2D,0,It,ht.width,ht.height,0,wt,Nt,null));else if(T.isDataTexture)if(Jt.length>0){Xt&&ge&&n.texStorage2D(e.TEXTURE_2D,xt,It,Jt[0].width,Jt[0].height);for(let Q=0,st=Jt.length;Q<st;Q++)yt=Jt[Q],Xt?B&&n.texSubImage2D(e.TEXTURE_2D,Q,0,0,yt.width,yt.height,wt,Nt,yt.data):n.texImage2D(e.TEXTURE_2D,Q,It,yt.width,yt.height,0,wt,Nt,yt.data);T.generateMipmaps=!1}else Xt?(ge&&n.texStorage2D(e.TEXTURE_2D,xt,It,ht.width,ht.height),B&&n.texSubImage2D(e.TEXTURE_2D,0,0,0,ht.width,ht.height,wt,Nt,ht.data)):n.texImage2D(e.TEXTURE_2D,0,It,ht.width,ht.height,0,wt,Nt,ht.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){Xt&&ge&&n.texStorage3D(e.TEXTURE_2D_ARRAY,xt,It,Jt[0].width,Jt[0].height,ht.depth);for(let Q=0,st=Jt.length;Q<st;Q++)if(yt=Jt[Q],T.format!==Pn)if(wt!==null)if(Xt){if(B)if(T.layerUpdates.size>0){let bt=xE(yt.width,yt.height,T.format,T.type);for(let _t of T.layerUpdates){let Ht=yt.data.subarray(_t*bt/yt.data.BYTES_PER_ELEMENT,(_t+1)*bt/yt.data.BYTES_PER_ELEMENT);n.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,Q,0,0,_t,yt.width,yt.height,1,wt,Ht)}T.clearLayerUpdates()}else n.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,Q,0,0,0,yt.width,yt.height,ht.depth,wt,yt.data)}else n.compressedTexImage3D(e.TEXTURE_2D_ARRAY,Q,It,yt.width,yt.height,ht.depth,0,yt.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Xt?B&&n.texSubImage3D(e.TEXTURE_2D_ARRAY,Q,0,0,0,yt.width,yt.height,ht.depth,wt,Nt,yt.data):n.texImage3D(e.TEXTURE_2D_ARRAY,Q,It,yt.width,yt.height,ht.depth,0,wt,Nt,yt.data)}else{Xt&&ge&&n.texStorage2D(e.TEXTURE_2D,xt,It,Jt[0].width,Jt[0].height);for(let Q=0,st=Jt.length;Q<st;Q++)yt=Jt[Q],T.format!==Pn?wt!==null?Xt?B&&n.compressedTexSubImage2D(e.TEXTURE_2D,Q,0,0,yt.width,yt.height,wt,yt.data):n.compressedTexImage2D(e.TEXTURE_2D,Q,It,yt.width,yt.height,0,yt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Xt?B&&n.texSubImage2D(e.TEXTURE_2D,Q,0,0,yt.width,yt.height,wt,Nt,yt.data):n.texImage2D(e.TEXTURE_2D,Q,It,yt.width,yt.height,0,wt,Nt,yt.data)}else if(T.isDataArrayTexture)if(Xt){if(ge&&n.texStorage3D(e.TEXTURE_2D_ARRAY,xt,It,ht.width,ht.height,ht.depth),B)if(T.layerUpdates.size>0){let Q=xE(ht.width,ht.height,T.format,T.type);for(let st of T.layerUpdates){let bt=ht.data.subarray(st*Q/ht.data.BYTES_PER_ELEMENT,(st+1)*Q/ht.data.BYTES_PER_ELEMENT);n.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,st,ht.width,ht.height,1,wt,Nt,bt)}T.clearLayerUpdates()}else n.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,0,ht.width,ht.height,ht.depth,wt,Nt,ht.data)}else n.texImage3D(e.TEXTURE_2D_ARRAY,0,It,ht.width,ht.height,ht.depth,0,wt,Nt,ht.data);else if(T.isData3DTexture)Xt?(ge&&n.texStorage3D(e.TEXTURE_3D,xt,It,ht.width,ht.height,ht.depth),B&&n.texSubImage3D(e.TEXTURE_3D,0,0,0,0,ht.width,ht.height,ht.depth,wt,Nt,ht.data)):n.texImage3D(e.TEXTURE_3D,0,It,ht.width,ht.height,ht.depth,0,wt,Nt,ht.data);else if(T.isFramebufferTexture){if(ge)if(Xt)n.texStorage2D(e.TEXTURE_2D,xt,It,ht.width,ht.height);else{let Q=ht.width,st=ht.height;for(let bt=0;bt<xt;bt++)n.texImage2D(e.TEXTURE_2D,bt,It,Q,st,0,wt,Nt,null),Q>>=1,st>>=1}}else if(Jt.length>0){if(Xt&&ge){let Q=Dt(Jt[0]);n.texStorage2D(e.TEXTURE_2D,xt,It,Q.width,Q.height)}for(let Q=0,st=Jt.length;Q<st;Q++)yt=Jt[Q],Xt?B&&n.texSubImage2D(e.TEXTURE_2D,Q,0,0,wt,Nt,yt):n.texImage2D(e.TEXTURE_2D,Q,It,wt,Nt,yt);T.generateMipmaps=!1}else if(Xt){if(ge){let Q=Dt(ht);n.texStorage2D(e.TEXTURE_2D,xt,It,Q.width,Q.height)}B&&n.texSubImage2D(e.TEXTURE_2D,0,0,0,wt,Nt,ht)}else n.texImage2D(e.TEXTURE_2D,0,It,wt,Nt,ht);g(T)&&p(rt),Et.__version=et.version,T.onUpdate&&T.onUpdate(T)}I.__version=T.version}function tt(I,T,W){if(T.image.length!==6)return;let rt=ft(I,T),at=T.source;n.bindTexture(e.TEXTURE_CUBE_MAP,I.__webglTexture,e.TEXTURE0+W);let et=i.get(at);if(at.version!==et.__version||rt===!0){n.activeTexture(e.TEXTURE0+W);let Et=ee.getPrimaries(ee.workingColorSpace),mt=T.colorSpace===rs?null:ee.getPrimaries(T.colorSpace),Mt=T.colorSpace===rs||Et===mt?e.NONE:e.BROWSER_DEFAULT_WEBGL;e.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(e.UNPACK_ALIGNMENT,T.unpackAlignment),e.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,Mt);let $t=T.isCompressedTexture||T.image[0].isCompressedTexture,ht=T.image[0]&&T.image[0].isDataTexture,wt=[];for(let st=0;st<6;st++)!$t&&!ht?wt[st]=y(T.image[st],!0,r.maxCubemapSize):wt[st]=ht?T.image[st].image:T.image[st],wt[st]=Qt(T,wt[st]);let Nt=wt[0],It=s.convert(T.format,T.colorSpace),yt=s.convert(T.type),Jt=b(T.internalFormat,It,yt,T.colorSpace),Xt=T.isVideoTexture!==!0,ge=et.__version===void 0||rt===!0,B=at.dataReady,xt=C(T,Nt);ct(e.TEXTURE_CUBE_MAP,T);let Q;if($t){Xt&&ge&&n.texStorage2D(e.TEXTURE_CUBE_MAP,xt,Jt,Nt.width,Nt.height);for(let st=0;st<6;st++){Q=wt[st].mipmaps;for(let bt=0;bt<Q.length;bt++){let _t=Q[bt];T.format!==Pn?It!==null?Xt?B&&n.compressedTexSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+st,bt,0,0,_t.width,_t.height,It,_t.data):n.compressedTexImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+st,bt,Jt,_t.width,_t.height,0,_t.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xt?B&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+st,bt,0,0,_t.width,_t.height,It,yt,_t.data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+st,bt,Jt,_t.width,_t.height,0,It,yt,_t.data)}}}else{if(Q=T.mipmaps,Xt&&ge){Q.length>0&&xt++;let st=Dt(wt[0]);n.texStorage2D(e.TEXTURE_CUBE_MAP,xt,Jt,st.width,st.height)}for(let st=0;st<6;st++)if(ht){Xt?B&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,0,0,wt[st].width,wt[st].height,It,yt,wt[st].data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,Jt,wt[st].width,wt[st].height,0,It,yt,wt[st].data);for(let bt=0;bt<Q.length;bt++){let Ht=Q[bt].image[st].image;Xt?B&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+st,bt+1,0,0,Ht.width,Ht.height,It,yt,Ht.data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+st,bt+1,Jt,Ht.width,Ht.height,0,It,yt,Ht.data)}}else{Xt?B&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,0,0,It,yt,wt[st]):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,Jt,It,yt,wt[st]);for(let bt=0;bt<Q.length;bt++){let _t=Q[bt];Xt?B&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+st,bt+1,0,0,It,yt,_t.image[st]):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+st,bt+1,Jt,It,yt,_t.image[st])}}}g(T)&&p(e.TEXTURE_CUBE_MAP),et.__version=at.version,T.onUpdate&&T.onUpdate(T)}I.__version=T.version}function lt(I,T,W,rt,at,et){let Et=s.convert(W.format,W.colorSpace),mt=s.convert(W.type),Mt=b(W.internalFormat,Et,mt,W.colorSpace),$t=i.get(T),ht=i.get(W);if(ht.__renderTarget=T,!$t.__hasExternalTextures){let wt=Math.max(1,T.width>>et),Nt=Math.max(1,T.height>>et);at===e.TEXTURE_3D||at===e.TEXTURE_2D_ARRAY?n.texImage3D(at,et,Mt,wt,Nt,T.depth,0,Et,mt,null):n.texImage2D(at,et,Mt,wt,Nt,0,Et,mt,null)}n.bindFramebuffer(e.FRAMEBUFFER,I),Ut(T)?a.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,rt,at,ht.__webglTexture,0,St(T)):(at===e.TEXTURE_2D||at>=e.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=e.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&e.framebufferTexture2D(e.FRAMEBUFFER,rt,at,ht.__webglTexture,et),n.bindFramebuffer(e.FRAMEBUFFER,null)}function K(I,T,W){if(e.bindRenderbuffer(e.RENDERBUFFER,I),T.depthBuffer){let rt=T.depthTexture,at=rt&&rt.isDepthTexture?rt.type:null,et=x(T.stencilBuffer,at),Et=T.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,mt=St(T);Ut(T)?a.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,mt,et,T.width,T.height):W?e.renderbufferStorageMultisample(e.RENDERBUFFER,mt,et,T.width,T.height):e.renderbufferStorage(e.RENDERBUFFER,et,T.width,T.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,Et,e.RENDERBUFFER,I)}else{let rt=T.textures;for(let at=0;at<rt.length;at++){let et=rt[at],Et=s.convert(et.format,et.colorSpace),mt=s.convert(et.type),Mt=b(et.internalFormat,Et,mt,et.colorSpace),$t=St(T);W&&Ut(T)===!1?e.renderbufferStorageMultisample(e.RENDERBUFFER,$t,Mt,T.width,T.height):Ut(T)?a.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,$t,Mt,T.width,T.height):e.renderbufferStorage(e.RENDERBUFFER,Mt,T.width,T.height)}}e.bindRenderbuffer(e.RENDERBUFFER,null)}function ut(I,T){if(T&&T.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(n.bindFramebuffer(e.FRAMEBUFFER,I),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let rt=i.get(T.depthTexture);rt.__renderTarget=T,(!rt.__webglTexture||T.depthTexture.image.width!==T.width||T.depthTexture.image.height!==T.height)&&(T.depthTexture.image.width=T.width,T.depthTexture.image.height=T.height,T.depthTexture.needsUpdate=!0),P(T.depthTexture,0);let at=rt.__webglTexture,et=St(T);if(T.depthTexture.format===Pa)Ut(T)?a.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,e.DEPTH_ATTACHMENT,e.TEXTURE_2D,at,0,et):e.framebufferTexture2D(e.FRAMEBUFFER,e.DEPTH_ATTACHMENT,e.TEXTURE_2D,at,0);else if(T.depthTexture.format===Ba)Ut(T)?a.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,e.DEPTH_STENCIL_ATTACHMENT,e.TEXTURE_2D,at,0,et):e.framebufferTexture2D(e.FRAMEBUFFER,e.DEPTH_STENCIL_ATTACHMENT,e.TEXTURE_2D,at,0);else throw new Error("Unknown depthTexture format")}function q(I){let T=i.get(I),W=I.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==I.depthTexture){let rt=I.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),rt){let at=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,rt.removeEventListener("dispose",at)};rt.addEventListener("dispose",at),T.__depthDisposeCallback=at}T.__boundDepthTexture=rt}if(I.depthTexture&&!T.__autoAllocateDepthBuffer){if(W)throw new Error("target.depthTexture not supported in Cube render targets");ut(T.__webglFramebuffer,I)}else if(W){T.__webglDepthbuffer=[];for(let rt=0;rt<6;rt++)if(n.bindFramebuffer(e.FRAMEBUFFER,T.__webglFramebuffer[rt]),T.__webglDepthbuffer[rt]===void 0)T.__webglDepthbuffer[rt]=e.createRenderbuffer(),K(T.__webglDepthbuffer[rt],I,!1);else{let at=I.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,et=T.__webglDepthbuffer[rt];e.bindRenderbuffer(e.RENDERBUFFER,et),e.framebufferRenderbuffer(e.FRAMEBUFFER,at,e.RENDERBUFFER,et)}}else if(n.bindFramebuffer(e.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=e.createRenderbuffer(),K(T.__webglDepthbuffer,I,!1);else{let rt=I.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,at=T.__webglDepthbuffer;e.bindRenderbuffer(e.RENDERBUFFER,at),e.framebufferRenderbuffer(e.FRAMEBUFFER,rt,e.RENDERBUFFER,at)}n.bindFramebuffer(e.FRAMEBUFFER,null)}function ot(I,T,W){let rt=i.get(I);T!==void 0&&lt(rt.__webglFramebuffer,I,I.texture,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,0),W!==void 0&&q(I)}function pt(I){let T=I.texture,W=i.get(I),rt=i.get(T);I.addEventListener("dispose",S);let at=I.textures,et=I.isWebGLCubeRenderTarget===!0,Et=at.length>1;if(Et||(rt.__webglTexture===void 0&&(rt.__webglTexture=e.createTexture()),rt.__version=T.version,o.memory.textures++),et){W.__webglFramebuffer=[];for(let mt=0;mt<6;mt++)if(T.mipmaps&&T.mipmaps.length>0){W.__webglFramebuffer[mt]=[];for(let Mt=0;Mt<T.mipmaps.length;Mt++)W.__webglFramebuffer[mt][Mt]=e.createFramebuffer()}else W.__webglFramebuffer[mt]=e.createFramebuffer()}else{if(T.mipmaps&&T.mipmaps.length>0){W.__webglFramebuffer=[];for(let mt=0;mt<T.mipmaps.length;mt++)W.__webglFramebuffer[mt]=e.createFramebuffer()}else W.__webglFramebuffer=e.createFramebuffer();if(Et)for(let mt=0,Mt=at.length;mt<Mt;mt++){let $t=i.get(at[mt]);$t.__webglTexture===void 0&&($t.__webglTexture=e.createTexture(),o.memory.textures++)}if(I.samples>0&&Ut(I)===!1){W.__webglMultisampledFramebuffer=e.createFramebuffer(),W.__webglColorRenderbuffer=[],n.bindFramebuffer(e.FRAMEBUFFER,W.__webglMultisampledFramebuffer);for(let mt=0;mt<at.length;mt++){let Mt=at[mt];W.__webglColorRenderbuffer[mt]=e.createRenderbuffer(),e.bindRenderbuffer(e.RENDERBUFFER,W.__webglColorRenderbuffer[mt]);let $t=s.convert(Mt.format,Mt.colorSpace),ht=s.convert(Mt.type),wt=b(Mt.internalFormat,$t,ht,Mt.colorSpace,I.isXRRenderTarget===!0),Nt=St(I);e.renderbufferStorageMultisample(e.RENDERBUFFER,Nt,wt,I.width,I.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+mt,e.RENDERBUFFER,W.__webglColorRenderbuffer[mt])}e.bindRenderbuffer(e.RENDERBUFFER,null),I.depthBuffer&&(W.__webglDepthRenderbuffer=e.createRenderbuffer(),K(W.__webglDepthRenderbuffer,I,!0)),n.bindFramebuffer(e.FRAMEBUFFER,null)}}if(et){n.bindTexture(e.TEXTURE_CUBE_MAP,rt.__webglTexture),ct(e.TEXTURE_CUBE_MAP,T);for(let mt=0;mt<6;mt++)if(T.mipmaps&&T.mipmaps.length>0)for(let Mt=0;Mt<T.mipmaps.length;Mt++)lt(W.__webglFramebuffer[mt][Mt],I,T,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+mt,Mt);else lt(W.__webglFramebuffer[mt],I,T,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0);g(T)&&p(e.TEXTURE_CUBE_MAP),n.unbindTexture()}else if(Et){for(let mt=0,Mt=at.length;mt<Mt;mt++){let $t=at[mt],ht=i.get($t);n.bindTexture(e.TEXTURE_2D,ht.__webglTexture),ct(e.TEXTURE_2D,$t),lt(W.__webglFramebuffer,I,$t,e.COLOR_ATTACHMENT0+mt,e.TEXTURE_2D,0),g($t)&&p(e.TEXTURE_2D)}n.unbindTexture()}else{let mt=e.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(mt=I.isWebGL3DRenderTarget?e.TEXTURE_3D:e.TEXTURE_2D_ARRAY),n.bindTexture(mt,rt.__webglTexture),ct(mt,T),T.mipmaps&&T.mipmaps.length>0)for(let Mt=0;Mt<T.mipmaps.length;Mt++)lt(W.__webglFramebuffer[Mt],I,T,e.COLOR_ATTACHMENT0,mt,Mt);else lt(W.__webglFramebuffer,I,T,e.COLOR_ATTACHMENT0,mt,0);g(T)&&p(mt),n.unbindTexture()}I.depthBuffer&&q(I)}function X(I){let T=I.textures;for(let W=0,rt=T.length;W<rt;W++){let at=T[W];if(g(at)){let et=_(I),Et=i.get(at).__webglTexture;n.bindTexture(et,Et),p(et),n.unbindTexture()}}}let Lt=[],L=[];function Ot(I){if(I.samples>0){if(Ut(I)===!1){let T=I.textures,W=I.width,rt=I.height,at=e.COLOR_BUFFER_BIT,et=I.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,Et=i.get(I),mt=T.length>1;if(mt)for(let Mt=0;Mt<T.length;Mt++)n.bindFramebuffer(e.FRAMEBUFFER,Et.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+Mt,e.RENDERBUFFER,null),n.bindFramebuffer(e.FRAMEBUFFER,Et.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+Mt,e.TEXTURE_2D,null,0);n.bindFramebuffer(e.READ_FRAMEBUFFER,Et.__webglMultisampledFramebuffer),n.bindFramebuffer(e.DRAW_FRAMEBUFFER,Et.__webglFramebuffer);for(let Mt=0;Mt<T.length;Mt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(at|=e.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(at|=e.STENCIL_BUFFER_BIT)),mt){e.framebufferRenderbuffer(e.READ_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.RENDERBUFFER,Et.__webglColorRenderbuffer[Mt]);let $t=i.get(T[Mt]).__webglTexture;e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,$t,0)}e.blitFramebuffer(0,0,W,rt,0,0,W,rt,at,e.NEAREST),c===!0&&(Lt.length=0,L.length=0,Lt.push(e.COLOR_ATTACHMENT0+Mt),I.depthBuffer&&I.resolveDepthBuffer===!1&&(Lt.push(et),L.push(et),e.invalidateFramebuffer(e.DRAW_FRAMEBUFFER,L)),e.invalidateFramebuffer(e.READ_FRAMEBUFFER,Lt))}if(n.bindFramebuffer(e.READ_FRAMEBUFFER,null),n.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),mt)for(let Mt=0;Mt<T.length;Mt++){n.bindFramebuffer(e.FRAMEBUFFER,Et.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+Mt,e.RENDERBUFFER,Et.__webglColorRenderbuffer[Mt]);let $t=i.get(T[Mt]).__webglTexture;n.bindFramebuffer(e.FRAMEBUFFER,Et.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+Mt,e.TEXTURE_2D,$t,0)}n.bindFramebuffer(e.DRAW_FRAMEBUFFER,Et.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.resolveDepthBuffer===!1&&c){let T=I.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;e.invalidateFramebuffer(e.DRAW_FRAMEBUFFER,[T])}}}function St(I){return Math.min(r.maxSamples,I.samples)}function Ut(I){let T=i.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function Tt(I){let T=o.render.frame;u.get(I)!==T&&(u.set(I,T),I.update())}function Qt(I,T){let W=I.colorSpace,rt=I.format,at=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||W!==Ha&&W!==rs&&(ee.getTransfer(W)===pe?(rt!==Pn||at!==Tr)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",W)),T}function Dt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(l.width=I.naturalWidth||I.width,l.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(l.width=I.displayWidth,l.height=I.displayHeight):(l.width=I.width,l.height=I.height),l}this.allocateTextureUnit=U,this.resetTextureUnits=N,this.setTexture2D=P,this.setTexture2DArray=O,this.setTexture3D=H,this.setTextureCube=z,this.rebindTextures=ot,this.setupRenderTarget=pt,this.updateRenderTargetMipmap=X,this.updateMultisampleRenderTarget=Ot,this.setupDepthRenderbuffer=q,this.setupFrameBufferTexture=lt,this.useMultisampledRTT=Ut}function lB(e,t){function n(i,r=rs){let s,o=ee.getTransfer(r);if(i===Tr)return e.UNSIGNED_BYTE;if(i===Rx)return e.UNSIGNED_SHORT_4_4_4_4;if(i===Ix)return e.UNSIGNED_SHORT_5_5_5_1;if(i===IE)return e.UNSIGNED_INT_5_9_9_9_REV;if(i===CE)return e.BYTE;if(i===RE)return e.SHORT;if(i===hl)return e.UNSIGNED_SHORT;if(i===Cx)return e.INT;if(i===oo)return e.UNSIGNED_INT;if(i===Mr)return e.FLOAT;if(i===gl)return e.HALF_FLOAT;if(i===PE)return e.ALPHA;if(i===LE)return e.RGB;if(i===Pn)return e.RGBA;if(i===NE)return e.LUMINANCE;if(i===DE)return e.LUMINANCE_ALPHA;if(i===Pa)return e.DEPTH_COMPONENT;if(i===Ba)return e.DEPTH_STENCIL;if(i===UE)return e.RED;if(i===Px)return e.RED_INTEGER;if(i===FE)return e.RG;if(i===Lx)return e.RG_INTEGER;if(i===Nx)return e.RGBA_INTEGER;if(i===oh||i===ah||i===ch||i===lh)if(o===pe)if(s=t.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===oh)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ah)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ch)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===lh)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=t.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===oh)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ah)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ch)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===lh)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===wy||i===Sy||i===Ty||i===Ey)if(s=t.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===wy)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Sy)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ty)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Ey)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Ay||i===Cy||i===Ry)if(s=t.get("WEBGL_compressed_texture_etc"),s!==null){if(i===Ay||i===Cy)return o===pe?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===Ry)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===Iy||i===Py||i===Ly||i===Ny||i===Dy||i===Uy||i===Fy||i===Oy||i===By||i===ky||i===zy||i===Vy||i===Hy||i===Gy)if(s=t.get("WEBGL_compressed_texture_astc"),s!==null){if(i===Iy)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Py)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Ly)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Ny)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Dy)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Uy)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Fy)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Oy)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===By)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===ky)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===zy)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Vy)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Hy)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Gy)return o===pe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===uh||i===Wy||i===$y)if(s=t.get("EXT_texture_compression_bptc"),s!==null){if(i===uh)return o===pe?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Wy)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===$y)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===OE||i===Xy||i===Yy||i===qy)if(s=t.get("EXT_texture_compression_rgtc"),s!==null){if(i===uh)return s.COMPRESSED_RED_RGTC1_EXT;if(i===Xy)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Yy)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===qy)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Oa?e.UNSIGNED_INT_24_8:e[i]!==void 0?e[i]:null}return{convert:n}}var fx=class extends dn{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}},ss=class extends Dn{constructor(){super(),this.isGroup=!0,this.type="Group"}},uB={type:"move"},fl=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ss,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ss,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Y,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Y),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ss,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Y,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Y),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let n=this._hand;if(n)for(let i of t.hand.values())this._getHandJoint(n,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,n,i){let r=null,s=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&n.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let y of t.hand.values()){let g=n.getJointPose(y,i),p=this._getHandJoint(l,y);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let u=l.joints["index-finger-tip"],h=l.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,m=.005;l.inputState.pinching&&f>d+m?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&f<=d-m&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(s=n.getPose(t.gripSpace,i),s!==null&&(c.matrix.fromArray(s.transform.matrix),c.matrix.decompose(c.position,c.rotation,c.scale),c.matrixWorldNeedsUpdate=!0,s.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(s.linearVelocity)):c.hasLinearVelocity=!1,s.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(s.angularVelocity)):c.hasAngularVelocity=!1));a!==null&&(r=n.getPose(t.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(uB)))}return a!==null&&(a.visible=r!==null),c!==null&&(c.visible=s!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,n){if(t.joints[n.jointName]===void 0){let i=new ss;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[n.jointName]=i,t.add(i)}return t.joints[n.jointName]}},fB=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,hB=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,hx=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,n,i){if(this.texture===null){let r=new Nn,s=t.properties.get(r);s.__webglTexture=n.texture,(n.depthNear!=i.depthNear||n.depthFar!=i.depthFar)&&(this.depthNear=n.depthNear,this.depthFar=n.depthFar),this.texture=r}}getMesh(t){if(this.texture!==null&&this.mesh===null){let n=t.cameras[0].viewport,i=new _i({vertexShader:fB,fragmentShader:hB,uniforms:{depthColor:{value:this.texture},depthWidth:{value:n.z},depthHeight:{value:n.w}}});this.mesh=new yi(new Th(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},dx=class extends ls{constructor(t,n){super();let i=this,r=null,s=1,o=null,a="local-floor",c=1,l=null,u=null,h=null,f=null,d=null,m=null,y=new hx,g=n.getContextAttributes(),p=null,_=null,b=[],x=[],C=new le,w=null,S=new dn;S.viewport=new Ne;let R=new dn;R.viewport=new Ne;let M=[S,R],v=new fx,E=null,N=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function($){let tt=b[$];return tt===void 0&&(tt=new fl,b[$]=tt),tt.getTargetRaySpace()},this.getControllerGrip=function($){let tt=b[$];return tt===void 0&&(tt=new fl,b[$]=tt),tt.getGripSpace()},this.getHand=function($){let tt=b[$];return tt===void 0&&(tt=new fl,b[$]=tt),tt.getHandSpace()};function U($){let tt=x.indexOf($.inputSource);if(tt===-1)return;let lt=b[tt];lt!==void 0&&(lt.update($.inputSource,$.frame,l||o),lt.dispatchEvent({type:$.type,data:$.inputSource}))}function F(){r.removeEventListener("select",U),r.removeEventListener("selectstart",U),r.removeEventListener("selectend",U),r.removeEventListener("squeeze",U),r.removeEventListener("squeezestart",U),r.removeEventListener("squeezeend",U),r.removeEventListener("end",F),r.removeEventListener("inputsourceschange",P);for(let $=0;$<b.length;$++){let tt=x[$];tt!==null&&(x[$]=null,b[$].disconnect(tt))}E=null,N=null,y.reset(),t.setRenderTarget(p),d=null,f=null,h=null,r=null,_=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(w),t.setSize(C.width,C.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function($){s=$,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function($){a=$,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function($){l=$},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h},this.getFrame=function(){return m},this.getSession=function(){return r},this.setSession=async function($){if(r=$,r!==null){if(p=t.getRenderTarget(),r.addEventListener("select",U),r.addEventListener("selectstart",U),r.addEventListener("selectend",U),r.addEventListener("squeeze",U),r.addEventListener("squeezestart",U),r.addEventListener("squeezeend",U),r.addEventListener("end",F),r.addEventListener("inputsourceschange",P),g.xrCompatible!==!0&&await n.makeXRCompatible(),w=t.getPixelRatio(),t.getSize(C),r.renderState.layers===void 0){let tt={antialias:g.antialias,alpha:!0,depth:g.depth,stencil:g.stencil,framebufferScaleFactor:s};d=new XRWebGLLayer(r,n,tt),r.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),_=new Er(d.framebufferWidth,d.framebufferHeight,{format:Pn,type:Tr,colorSpace:t.outputColorSpace,stencilBuffer:g.stencil})}else{let tt=null,lt=null,K=null;g.depth&&(K=g.stencil?n.DEPTH24_STENCIL8:n.DEPTH_COMPONENT24,tt=g.stencil?Ba:Pa,lt=g.stencil?Oa:oo);let ut={colorFormat:n.RGBA8,depthFormat:K,scaleFactor:s};h=new XRWebGLBinding(r,n),f=h.createProjectionLayer(ut),r.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),_=new Er(f.textureWidth,f.textureHeight,{format:Pn,type:Tr,depthTexture:new Ah(f.textureWidth,f.textureHeight,lt,void 0,void 0,void 0,void 0,void 0,void 0,tt),stencilBuffer:g.stencil,colorSpace:t.outputColorSpace,samples:g.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1})}_.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await r.requestReferenceSpace(a),ft.setContext(r),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return y.getDepthTexture()};function P($){for(let tt=0;tt<$.removed.length;tt++){let lt=$.removed[tt],K=x.indexOf(lt);K>=0&&(x[K]=null,b[K].disconnect(lt))}for(let tt=0;tt<$.added.length;tt++){let lt=$.added[tt],K=x.indexOf(lt);if(K===-1){for(let q=0;q<b.length;q++)if(q>=x.length){x.push(lt),K=q;break}else if(x[q]===null){x[q]=lt,K=q;break}if(K===-1)break}let ut=b[K];ut&&ut.connect(lt)}}let O=new Y,H=new Y;function z($,tt,lt){O.setFromMatrixPosition(tt.matrixWorld),H.setFromMatrixPosition(lt.matrixWorld);let K=O.distanceTo(H),ut=tt.projectionMatrix.elements,q=lt.projectionMatrix.elements,ot=ut[14]/(ut[10]-1),pt=ut[14]/(ut[10]+1),X=(ut[9]+1)/ut[5],Lt=(ut[9]-1)/ut[5],L=(ut[8]-1)/ut[0],Ot=(q[8]+1)/q[0],St=ot*L,Ut=ot*Ot,Tt=K/(-L+Ot),Qt=Tt*-L;if(tt.matrixWorld.decompose($.position,$.quaternion,$.scale),$.translateX(Qt),$.translateZ(Tt),$.matrixWorld.compose($.position,$.quaternion,$.scale),$.matrixWorldInverse.copy($.matrixWorld).invert(),ut[10]===-1)$.projectionMatrix.copy(tt.projectionMatrix),$.projectionMatrixInverse.copy(tt.projectionMatrixInverse);else{let Dt=ot+Tt,I=pt+Tt,T=St-Qt,W=Ut+(K-Qt),rt=X*pt/I*Dt,at=Lt*pt/I*Dt;$.projectionMatrix.makePerspective(T,W,rt,at,Dt,I),$.projectionMatrixInverse.copy($.projectionMatrix).invert()}}function G($,tt){tt===null?$.matrixWorld.copy($.matrix):$.matrixWorld.multiplyMatrices(tt.matrixWorld,$.matrix),$.matrixWorldInverse.copy($.matrixWorld).invert()}this.updateCamera=function($){if(r===null)return;let tt=$.near,lt=$.far;y.texture!==null&&(y.depthNear>0&&(tt=y.depthNear),y.depthFar>0&&(lt=y.depthFar)),v.near=R.near=S.near=tt,v.far=R.far=S.far=lt,(E!==v.near||N!==v.far)&&(r.updateRenderState({depthNear:v.near,depthFar:v.far}),E=v.near,N=v.far),S.layers.mask=$.layers.mask|2,R.layers.mask=$.layers.mask|4,v.layers.mask=S.layers.mask|R.layers.mask;let K=$.parent,ut=v.cameras;G(v,K);for(let q=0;q<ut.length;q++)G(ut[q],K);ut.length===2?z(v,S,R):v.projectionMatrix.copy(S.projectionMatrix),j($,v,K)};function j($,tt,lt){lt===null?$.matrix.copy(tt.matrixWorld):($.matrix.copy(lt.matrixWorld),$.matrix.invert(),$.matrix.multiply(tt.matrixWorld)),$.matrix.decompose($.position,$.quaternion,$.scale),$.updateMatrixWorld(!0),$.projectionMatrix.copy(tt.projectionMatrix),$.projectionMatrixInverse.copy(tt.projectionMatrixInverse),$.isPerspectiveCamera&&($.fov=Jy*2*Math.atan(1/$.projectionMatrix.elements[5]),$.zoom=1)}this.getCamera=function(){return v},this.getFoveation=function(){if(!(f===null&&d===null))return c},this.setFoveation=function($){c=$,f!==null&&(f.fixedFoveation=$),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=$)},this.hasDepthSensing=function(){return y.texture!==null},this.getDepthSensingMesh=function(){return y.getMesh(v)};let nt=null;function ct($,tt){if(u=tt.getViewerPose(l||o),m=tt,u!==null){let lt=u.views;d!==null&&(t.setRenderTargetFramebuffer(_,d.framebuffer),t.setRenderTarget(_));let K=!1;lt.length!==v.cameras.length&&(v.cameras.length=0,K=!0);for(let q=0;q<lt.length;q++){let ot=lt[q],pt=null;if(d!==null)pt=d.getViewport(ot);else{let Lt=h.getViewSubImage(f,ot);pt=Lt.viewport,q===0&&(t.setRenderTargetTextures(_,Lt.colorTexture,f.ignoreDepthValues?void 0:Lt.depthStencilTexture),t.setRenderTarget(_))}let X=M[q];X===void 0&&(X=new dn,X.layers.enable(q),X.viewport=new Ne,M[q]=X),X.matrix.fromArray(ot.transform.matrix),X.matrix.decompose(X.position,X.quaternion,X.scale),X.projectionMatrix.fromArray(ot.projectionMatrix),X.projectionMatrixInverse.copy(X.projectionMatrix).invert(),X.viewport.set(pt.x,pt.y,pt.width,pt.height),q===0&&(v.matrix.copy(X.matrix),v.matrix.decompose(v.position,v.quaternion,v.scale)),K===!0&&v.cameras.push(X)}let ut=r.enabledFeatures;if(ut&&ut.includes("depth-sensing")){let q=h.getDepthInformation(lt[0]);q&&q.isValid&&q.texture&&y.init(t,q,r.renderState)}}for(let lt=0;lt<b.length;lt++){let K=x[lt],ut=b[lt];K!==null&&ut!==void 0&&ut.update(K,tt,l||o)}nt&&nt($,tt),tt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:tt}),m=null}let ft=new HE;ft.setAnimationLoop(ct),this.setAnimationLoop=function($){nt=$},this.dispose=function(){}}},Qs=new Ar,dB=new De;function pB(e,t){function n(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function i(g,p){p.color.getRGB(g.fogColor.value,VE(e)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function r(g,p,_,b,x){p.isMeshBasicMaterial||p.isMeshLambertMaterial?s(g,p):p.isMeshToonMaterial?(s(g,p),h(g,p)):p.isMeshPhongMaterial?(s(g,p),u(g,p)):p.isMeshStandardMaterial?(s(g,p),f(g,p),p.isMeshPhysicalMaterial&&d(g,p,x)):p.isMeshMatcapMaterial?(s(g,p),m(g,p)):p.isMeshDepthMaterial?s(g,p):p.isMeshDistanceMaterial?(s(g,p),y(g,p)):p.isMeshNormalMaterial?s(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?c(g,p,_,b):p.isSpriteMaterial?l(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function s(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,n(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,n(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,n(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===Mn&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,n(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===Mn&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,n(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,n(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,n(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let _=t.get(p),b=_.envMap,x=_.envMapRotation;b&&(g.envMap.value=b,Qs.copy(x),Qs.x*=-1,Qs.y*=-1,Qs.z*=-1,b.isCubeTexture&&b.isRenderTargetTexture===!1&&(Qs.y*=-1,Qs.z*=-1),g.envMapRotation.value.setFromMatrix4(dB.makeRotationFromEuler(Qs)),g.flipEnvMap.value=b.isCubeTexture&&b.isRenderTargetTexture===!1?-1:1,g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,n(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,n(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,n(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function c(g,p,_,b){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*_,g.scale.value=b*.5,p.map&&(g.map.value=p.map,n(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,n(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function l(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,n(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,n(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function u(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function h(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function f(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,n(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,n(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function d(g,p,_){g.ior.value=p.ior,p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,n(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,n(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,n(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,n(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,n(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Mn&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],g.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,n(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,n(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=_.texture,g.transmissionSamplerSize.value.set(_.width,_.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,n(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,n(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,n(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,n(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,n(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function y(g,p){let _=t.get(p).light;g.referencePosition.value.setFromMatrixPosition(_.matrixWorld),g.nearDistance.value=_.shadow.camera.near,g.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function mB(e,t,n,i){let r={},s={},o=[],a=e.getParameter(e.MAX_UNIFORM_BUFFER_BINDINGS);function c(_,b){let x=b.program;i.uniformBlockBinding(_,x)}function l(_,b){let x=r[_.id];x===void 0&&(m(_),x=u(_),r[_.id]=x,_.addEventListener("dispose",g));let C=b.program;i.updateUBOMapping(_,C);let w=t.render.frame;s[_.id]!==w&&(f(_),s[_.id]=w)}function u(_){let b=h();_.__bindingPointIndex=b;let x=e.createBuffer(),C=_.__size,w=_.usage;return e.bindBuffer(e.UNIFORM_BUFFER,x),e.bufferData(e.UNIFORM_BUFFER,C,w),e.bindBuffer(e.UNIFORM_BUFFER,null),e.bindBufferBase(e.UNIFORM_BUFFER,b,x),x}function h(){for(let _=0;_<a;_++)if(o.indexOf(_)===-1)return o.push(_),_;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(_){let b=r[_.id],x=_.uniforms,C=_.__cache;e.bindBuffer(e.UNIFORM_BUFFER,b);for(let w=0,S=x.length;w<S;w++){let R=Array.isArray(x[w])?x[w]:[x[w]];for(let M=0,v=R.length;M<v;M++){let E=R[M];if(d(E,w,M,C)===!0){let N=E.__offset,U=Array.isArray(E.value)?E.value:[E.value],F=0;for(let P=0;P<U.length;P++){let O=U[P],H=y(O);typeof O=="number"||typeof O=="boolean"?(E.__data[0]=O,e.bufferSubData(e.UNIFORM_BUFFER,N+F,E.__data)):O.isMatrix3?(E.__data[0]=O.elements[0],E.__data[1]=O.elements[1],E.__data[2]=O.elements[2],E.__data[3]=0,E.__data[4]=O.elements[3],E.__data[5]=O.elements[4],E.__data[6]=O.elements[5],E.__data[7]=0,E.__data[8]=O.elements[6],E.__data[9]=O.elements[7],E.__data[10]=O.elements[8],E.__data[11]=0):(O.toArray(E.__data,F),F+=H.storage/Float32Array.BYTES_PER_ELEMENT)}e.bufferSubData(e.UNIFORM_BUFFER,N,E.__data)}}}e.bindBuffer(e.UNIFORM_BUFFER,null)}function d(_,b,x,C){let w=_.value,S=b+"_"+x;if(C[S]===void 0)return typeof w=="number"||typeof w=="boolean"?C[S]=w:C[S]=w.clone(),!0;{let R=C[S];if(typeof w=="number"||typeof w=="boolean"){if(R!==w)return C[S]=w,!0}else if(R.equals(w)===!1)return R.copy(w),!0}return!1}function m(_){let b=_.uniforms,x=0,C=16;for(let S=0,R=b.length;S<R;S++){let M=Array.isArray(b[S])?b[S]:[b[S]];for(let v=0,E=M.length;v<E;v++){let N=M[v],U=Array.isArray(N.value)?N.value:[N.value];for(let F=0,P=U.length;F<P;F++){let O=U[F],H=y(O),z=x%C,G=z%H.boundary,j=z+G;x+=G,j!==0&&C-j<H.storage&&(x+=C-j),N.__data=new Float32Array(H.storage/Float32Array.BYTES_PER_ELEMENT),N.__offset=x,x+=H.storage}}}let w=x%C;return w>0&&(x+=C-w),_.__size=x,_.__cache={},this}function y(_){let b={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(b.boundary=4,b.storage=4):_.isVector2?(b.boundary=8,b.storage=8):_.isVector3||_.isColor?(b.boundary=16,b.storage=12):_.isVector4?(b.boundary=16,b.storage=16):_.isMatrix3?(b.boundary=48,b.storage=48):_.isMatrix4?(b.boundary=64,b.storage=64):_.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",_),b}function g(_){let b=_.target;b.removeEventListener("dispose",g);let x=o.indexOf(b.__bindingPointIndex);o.splice(x,1),e.deleteBuffer(r[b.id]),delete r[b.id],delete s[b.id]}function p(){for(let _ in r)e.deleteBuffer(r[_]);o=[],r={},s={}}return{bind:c,update:l,dispose:p}}var Ch=class{constructor(t={}){let{canvas:n=_4(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reverseDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let d;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");d=i.getContextAttributes().alpha}else d=o;let m=new Uint32Array(4),y=new Int32Array(4),g=null,p=null,_=[],b=[];this.domElement=n,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=ti,this.toneMapping=as,this.toneMappingExposure=1;let x=this,C=!1,w=0,S=0,R=null,M=-1,v=null,E=new Ne,N=new Ne,U=null,F=new Kt(0),P=0,O=n.width,H=n.height,z=1,G=null,j=null,nt=new Ne(0,0,O,H),ct=new Ne(0,0,O,H),ft=!1,$=new Sh,tt=!1,lt=!1,K=new De,ut=new De,q=new Y,ot=new Ne,pt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},X=!1;function Lt(){return R===null?z:1}let L=i;function Ot(A,k){return n.getContext(A,k)}try{let A={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in n&&n.setAttribute("data-engine",`three.js r${Ax}`),n.addEventListener("webglcontextlost",st,!1),n.addEventListener("webglcontextrestored",bt,!1),n.addEventListener("webglcontextcreationerror",_t,!1),L===null){let k="webgl2";if(L=Ot(k,A),L===null)throw Ot(k)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(A){throw console.error("THREE.WebGLRenderer: "+A.message),A}let St,Ut,Tt,Qt,Dt,I,T,W,rt,at,et,Et,mt,Mt,$t,ht,wt,Nt,It,yt,Jt,Xt,ge,B;function xt(){St=new PO(L),St.init(),Xt=new lB(L,St),Ut=new TO(L,St,t,Xt),Tt=new oB(L,St),Ut.reverseDepthBuffer&&f&&Tt.buffers.depth.setReversed(!0),Qt=new DO(L),Dt=new Y6,I=new cB(L,St,Tt,Dt,Ut,Xt,Qt),T=new AO(x),W=new IO(x),rt=new V4(L),ge=new wO(L,rt),at=new LO(L,rt,Qt,ge),et=new FO(L,at,rt,Qt),It=new UO(L,Ut,I),ht=new EO(Dt),Et=new X6(x,T,W,St,Ut,ge,ht),mt=new pB(x,Dt),Mt=new Z6,$t=new eB(St),Nt=new MO(x,T,W,Tt,et,d,c),wt=new rB(x,et,Ut),B=new mB(L,Qt,Ut,Tt),yt=new SO(L,St,Qt),Jt=new NO(L,St,Qt),Qt.programs=Et.programs,x.capabilities=Ut,x.extensions=St,x.properties=Dt,x.renderLists=Mt,x.shadowMap=wt,x.state=Tt,x.info=Qt}xt();let Q=new dx(x,L);this.xr=Q,this.getContext=function(){return L},this.getContextAttributes=function(){return L.getContextAttributes()},this.forceContextLoss=function(){let A=St.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=St.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return z},this.setPixelRatio=function(A){A!==void 0&&(z=A,this.setSize(O,H,!1))},this.getSize=function(A){return A.set(O,H)},this.setSize=function(A,k,Z=!0){if(Q.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}O=A,H=k,n.width=Math.floor(A*z),n.height=Math.floor(k*z),Z===!0&&(n.style.width=A+"px",n.style.height=k+"px"),this.setViewport(0,0,A,k)},this.getDrawingBufferSize=function(A){return A.set(O*z,H*z).floor()},this.setDrawingBufferSize=function(A,k,Z){O=A,H=k,z=Z,n.width=Math.floor(A*Z),n.height=Math.floor(k*Z),this.setViewport(0,0,A,k)},this.getCurrentViewport=function(A){return A.copy(E)},this.getViewport=function(A){return A.copy(nt)},this.setViewport=function(A,k,Z,J){A.isVector4?nt.set(A.x,A.y,A.z,A.w):nt.set(A,k,Z,J),Tt.viewport(E.copy(nt).multiplyScalar(z).round())},this.getScissor=function(A){return A.copy(ct)},this.setScissor=function(A,k,Z,J){A.isVector4?ct.set(A.x,A.y,A.z,A.w):ct.set(A,k,Z,J),Tt.scissor(N.copy(ct).multiplyScalar(z).round())},this.getScissorTest=function(){return ft},this.setScissorTest=function(A){Tt.setScissorTest(ft=A)},this.setOpaqueSort=function(A){G=A},this.setTransparentSort=function(A){j=A},this.getClearColor=function(A){return A.copy(Nt.getClearColor())},this.setClearColor=function(){Nt.setClearColor.apply(Nt,arguments)},this.getClearAlpha=function(){return Nt.getClearAlpha()},this.setClearAlpha=function(){Nt.setClearAlpha.apply(Nt,arguments)},this.clear=function(A=!0,k=!0,Z=!0){let J=0;if(A){let V=!1;if(R!==null){let dt=R.texture.format;V=dt===Nx||dt===Lx||dt===Px}if(V){let dt=R.texture.type,vt=dt===Tr||dt===oo||dt===hl||dt===Oa||dt===Rx||dt===Ix,At=Nt.getClearColor(),Ct=Nt.getClearAlpha(),Bt=At.r,Gt=At.g,Rt=At.b;vt?(m[0]=Bt,m[1]=Gt,m[2]=Rt,m[3]=Ct,L.clearBufferuiv(L.COLOR,0,m)):(y[0]=Bt,y[1]=Gt,y[2]=Rt,y[3]=Ct,L.clearBufferiv(L.COLOR,0,y))}else J|=L.COLOR_BUFFER_BIT}k&&(J|=L.DEPTH_BUFFER_BIT),Z&&(J|=L.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),L.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){n.removeEventListener("webglcontextlost",st,!1),n.removeEventListener("webglcontextrestored",bt,!1),n.removeEventListener("webglcontextcreationerror",_t,!1),Mt.dispose(),$t.dispose(),Dt.dispose(),T.dispose(),W.dispose(),et.dispose(),ge.dispose(),B.dispose(),Et.dispose(),Q.dispose(),Q.removeEventListener("sessionstart",Kx),Q.removeEventListener("sessionend",jx),hs.stop()};function st(A){A.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),C=!0}function bt(){console.log("THREE.WebGLRenderer: Context Restored."),C=!1;let A=Qt.autoReset,k=wt.enabled,Z=wt.autoUpdate,J=wt.needsUpdate,V=wt.type;xt(),Qt.autoReset=A,wt.enabled=k,wt.autoUpdate=Z,wt.needsUpdate=J,wt.type=V}function _t(A){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function Ht(A){let k=A.target;k.removeEventListener("dispose",Ht),Se(k)}function Se(A){Qe(A),Dt.remove(A)}function Qe(A){let k=Dt.get(A).programs;k!==void 0&&(k.forEach(function(Z){Et.releaseProgram(Z)}),A.isShaderMaterial&&Et.releaseShaderCache(A))}this.renderBufferDirect=function(A,k,Z,J,V,dt){k===null&&(k=pt);let vt=V.isMesh&&V.matrixWorld.determinant()<0,At=MA(A,k,Z,J,V);Tt.setMaterial(J,vt);let Ct=Z.index,Bt=1;if(J.wireframe===!0){if(Ct=at.getWireframeAttribute(Z),Ct===void 0)return;Bt=2}let Gt=Z.drawRange,Rt=Z.attributes.position,ne=Gt.start*Bt,ye=(Gt.start+Gt.count)*Bt;dt!==null&&(ne=Math.max(ne,dt.start*Bt),ye=Math.min(ye,(dt.start+dt.count)*Bt)),Ct!==null?(ne=Math.max(ne,0),ye=Math.min(ye,Ct.count)):Rt!=null&&(ne=Math.max(ne,0),ye=Math.min(ye,Rt.count));let xe=ye-ne;if(xe<0||xe===1/0)return;ge.setup(V,J,At,Z,Ct);let pn,re=yt;if(Ct!==null&&(pn=rt.get(Ct),re=Jt,re.setIndex(pn)),V.isMesh)J.wireframe===!0?(Tt.setLineWidth(J.wireframeLinewidth*Lt()),re.setMode(L.LINES)):re.setMode(L.TRIANGLES);else if(V.isLine){let Pt=J.linewidth;Pt===void 0&&(Pt=1),Tt.setLineWidth(Pt*Lt()),V.isLineSegments?re.setMode(L.LINES):V.isLineLoop?re.setMode(L.LINE_LOOP):re.setMode(L.LINE_STRIP)}else V.isPoints?re.setMode(L.POINTS):V.isSprite&&re.setMode(L.TRIANGLES);if(V.isBatchedMesh)if(V._multiDrawInstances!==null)re.renderMultiDrawInstances(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount,V._multiDrawInstances);else if(St.get("WEBGL_multi_draw"))re.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{let Pt=V._multiDrawStarts,Xi=V._multiDrawCounts,se=V._multiDrawCount,ni=Ct?rt.get(Ct).bytesPerElement:1,fo=Dt.get(J).currentProgram.getUniforms();for(let Sn=0;Sn<se;Sn++)fo.setValue(L,"_gl_DrawID",Sn),re.render(Pt[Sn]/ni,Xi[Sn])}else if(V.isInstancedMesh)re.renderInstances(ne,xe,V.count);else if(Z.isInstancedBufferGeometry){let Pt=Z._maxInstanceCount!==void 0?Z._maxInstanceCount:1/0,Xi=Math.min(Z.instanceCount,Pt);re.renderInstances(ne,xe,Xi)}else re.render(ne,xe)};function ae(A,k,Z){A.transparent===!0&&A.side===br&&A.forceSinglePass===!1?(A.side=Mn,A.needsUpdate=!0,vl(A,k,Z),A.side=cs,A.needsUpdate=!0,vl(A,k,Z),A.side=br):vl(A,k,Z)}this.compile=function(A,k,Z=null){Z===null&&(Z=A),p=$t.get(Z),p.init(k),b.push(p),Z.traverseVisible(function(V){V.isLight&&V.layers.test(k.layers)&&(p.pushLight(V),V.castShadow&&p.pushShadow(V))}),A!==Z&&A.traverseVisible(function(V){V.isLight&&V.layers.test(k.layers)&&(p.pushLight(V),V.castShadow&&p.pushShadow(V))}),p.setupLights();let J=new Set;return A.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;let dt=V.material;if(dt)if(Array.isArray(dt))for(let vt=0;vt<dt.length;vt++){let At=dt[vt];ae(At,Z,V),J.add(At)}else ae(dt,Z,V),J.add(dt)}),b.pop(),p=null,J},this.compileAsync=function(A,k,Z=null){let J=this.compile(A,k,Z);return new Promise(V=>{function dt(){if(J.forEach(function(vt){Dt.get(vt).currentProgram.isReady()&&J.delete(vt)}),J.size===0){V(A);return}setTimeout(dt,10)}St.get("KHR_parallel_shader_compile")!==null?dt():setTimeout(dt,10)})};let ei=null;function $i(A){ei&&ei(A)}function Kx(){hs.stop()}function jx(){hs.start()}let hs=new HE;hs.setAnimationLoop($i),typeof self<"u"&&hs.setContext(self),this.setAnimationLoop=function(A){ei=A,Q.setAnimationLoop(A),A===null?hs.stop():hs.start()},Q.addEventListener("sessionstart",Kx),Q.addEventListener("sessionend",jx),this.render=function(A,k){if(k!==void 0&&k.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),Q.enabled===!0&&Q.isPresenting===!0&&(Q.cameraAutoUpdate===!0&&Q.updateCamera(k),k=Q.getCamera()),A.isScene===!0&&A.onBeforeRender(x,A,k,R),p=$t.get(A,b.length),p.init(k),b.push(p),ut.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),$.setFromProjectionMatrix(ut),lt=this.localClippingEnabled,tt=ht.init(this.clippingPlanes,lt),g=Mt.get(A,_.length),g.init(),_.push(g),Q.enabled===!0&&Q.isPresenting===!0){let dt=x.xr.getDepthSensingMesh();dt!==null&&$h(dt,k,-1/0,x.sortObjects)}$h(A,k,0,x.sortObjects),g.finish(),x.sortObjects===!0&&g.sort(G,j),X=Q.enabled===!1||Q.isPresenting===!1||Q.hasDepthSensing()===!1,X&&Nt.addToRenderList(g,A),this.info.render.frame++,tt===!0&&ht.beginShadows();let Z=p.state.shadowsArray;wt.render(Z,A,k),tt===!0&&ht.endShadows(),this.info.autoReset===!0&&this.info.reset();let J=g.opaque,V=g.transmissive;if(p.setupLights(),k.isArrayCamera){let dt=k.cameras;if(V.length>0)for(let vt=0,At=dt.length;vt<At;vt++){let Ct=dt[vt];t_(J,V,A,Ct)}X&&Nt.render(A);for(let vt=0,At=dt.length;vt<At;vt++){let Ct=dt[vt];Qx(g,A,Ct,Ct.viewport)}}else V.length>0&&t_(J,V,A,k),X&&Nt.render(A),Qx(g,A,k);R!==null&&(I.updateMultisampleRenderTarget(R),I.updateRenderTargetMipmap(R)),A.isScene===!0&&A.onAfterRender(x,A,k),ge.resetDefaultState(),M=-1,v=null,b.pop(),b.length>0?(p=b[b.length-1],tt===!0&&ht.setGlobalState(x.clippingPlanes,p.state.camera)):p=null,_.pop(),_.length>0?g=_[_.length-1]:g=null};function $h(A,k,Z,J){if(A.visible===!1)return;if(A.layers.test(k.layers)){if(A.isGroup)Z=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(k);else if(A.isLight)p.pushLight(A),A.castShadow&&p.pushShadow(A);else if(A.isSprite){if(!A.frustumCulled||$.intersectsSprite(A)){J&&ot.setFromMatrixPosition(A.matrixWorld).applyMatrix4(ut);let vt=et.update(A),At=A.material;At.visible&&g.push(A,vt,At,Z,ot.z,null)}}else if((A.isMesh||A.isLine||A.isPoints)&&(!A.frustumCulled||$.intersectsObject(A))){let vt=et.update(A),At=A.material;if(J&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),ot.copy(A.boundingSphere.center)):(vt.boundingSphere===null&&vt.computeBoundingSphere(),ot.copy(vt.boundingSphere.center)),ot.applyMatrix4(A.matrixWorld).applyMatrix4(ut)),Array.isArray(At)){let Ct=vt.groups;for(let Bt=0,Gt=Ct.length;Bt<Gt;Bt++){let Rt=Ct[Bt],ne=At[Rt.materialIndex];ne&&ne.visible&&g.push(A,vt,ne,Z,ot.z,Rt)}}else At.visible&&g.push(A,vt,At,Z,ot.z,null)}}let dt=A.children;for(let vt=0,At=dt.length;vt<At;vt++)$h(dt[vt],k,Z,J)}function Qx(A,k,Z,J){let V=A.opaque,dt=A.transmissive,vt=A.transparent;p.setupLightsView(Z),tt===!0&&ht.setGlobalState(x.clippingPlanes,Z),J&&Tt.viewport(E.copy(J)),V.length>0&&_l(V,k,Z),dt.length>0&&_l(dt,k,Z),vt.length>0&&_l(vt,k,Z),Tt.buffers.depth.setTest(!0),Tt.buffers.depth.setMask(!0),Tt.buffers.color.setMask(!0),Tt.setPolygonOffset(!1)}function t_(A,k,Z,J){if((Z.isScene===!0?Z.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[J.id]===void 0&&(p.state.transmissionRenderTarget[J.id]=new Er(1,1,{generateMipmaps:!0,type:St.has("EXT_color_buffer_half_float")||St.has("EXT_color_buffer_float")?gl:Tr,minFilter:so,samples:4,stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ee.workingColorSpace}));let dt=p.state.transmissionRenderTarget[J.id],vt=J.viewport||E;dt.setSize(vt.z,vt.w);let At=x.getRenderTarget();x.setRenderTarget(dt),x.getClearColor(F),P=x.getClearAlpha(),P<1&&x.setClearColor(16777215,.5),x.clear(),X&&Nt.render(Z);let Ct=x.toneMapping;x.toneMapping=as;let Bt=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),p.setupLightsView(J),tt===!0&&ht.setGlobalState(x.clippingPlanes,J),_l(A,Z,J),I.updateMultisampleRenderTarget(dt),I.updateRenderTargetMipmap(dt),St.has("WEBGL_multisampled_render_to_texture")===!1){let Gt=!1;for(let Rt=0,ne=k.length;Rt<ne;Rt++){let ye=k[Rt],xe=ye.object,pn=ye.geometry,re=ye.material,Pt=ye.group;if(re.side===br&&xe.layers.test(J.layers)){let Xi=re.side;re.side=Mn,re.needsUpdate=!0,e_(xe,Z,J,pn,re,Pt),re.side=Xi,re.needsUpdate=!0,Gt=!0}}Gt===!0&&(I.updateMultisampleRenderTarget(dt),I.updateRenderTargetMipmap(dt))}x.setRenderTarget(At),x.setClearColor(F,P),Bt!==void 0&&(J.viewport=Bt),x.toneMapping=Ct}function _l(A,k,Z){let J=k.isScene===!0?k.overrideMaterial:null;for(let V=0,dt=A.length;V<dt;V++){let vt=A[V],At=vt.object,Ct=vt.geometry,Bt=J===null?vt.material:J,Gt=vt.group;At.layers.test(Z.layers)&&e_(At,k,Z,Ct,Bt,Gt)}}function e_(A,k,Z,J,V,dt){A.onBeforeRender(x,k,Z,J,V,dt),A.modelViewMatrix.multiplyMatrices(Z.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),V.onBeforeRender(x,k,Z,J,A,dt),V.transparent===!0&&V.side===br&&V.forceSinglePass===!1?(V.side=Mn,V.needsUpdate=!0,x.renderBufferDirect(Z,k,J,V,A,dt),V.side=cs,V.needsUpdate=!0,x.renderBufferDirect(Z,k,J,V,A,dt),V.side=br):x.renderBufferDirect(Z,k,J,V,A,dt),A.onAfterRender(x,k,Z,J,V,dt)}function vl(A,k,Z){k.isScene!==!0&&(k=pt);let J=Dt.get(A),V=p.state.lights,dt=p.state.shadowsArray,vt=V.state.version,At=Et.getParameters(A,V.state,dt,k,Z),Ct=Et.getProgramCacheKey(At),Bt=J.programs;J.environment=A.isMeshStandardMaterial?k.environment:null,J.fog=k.fog,J.envMap=(A.isMeshStandardMaterial?W:T).get(A.envMap||J.environment),J.envMapRotation=J.environment!==null&&A.envMap===null?k.environmentRotation:A.envMapRotation,Bt===void 0&&(A.addEventListener("dispose",Ht),Bt=new Map,J.programs=Bt);let Gt=Bt.get(Ct);if(Gt!==void 0){if(J.currentProgram===Gt&&J.lightsStateVersion===vt)return i_(A,At),Gt}else At.uniforms=Et.getUniforms(A),A.onBeforeCompile(At,x),Gt=Et.acquireProgram(At,Ct),Bt.set(Ct,Gt),J.uniforms=At.uniforms;let Rt=J.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Rt.clippingPlanes=ht.uniform),i_(A,At),J.needsLights=SA(A),J.lightsStateVersion=vt,J.needsLights&&(Rt.ambientLightColor.value=V.state.ambient,Rt.lightProbe.value=V.state.probe,Rt.directionalLights.value=V.state.directional,Rt.directionalLightShadows.value=V.state.directionalShadow,Rt.spotLights.value=V.state.spot,Rt.spotLightShadows.value=V.state.spotShadow,Rt.rectAreaLights.value=V.state.rectArea,Rt.ltc_1.value=V.state.rectAreaLTC1,Rt.ltc_2.value=V.state.rectAreaLTC2,Rt.pointLights.value=V.state.point,Rt.pointLightShadows.value=V.state.pointShadow,Rt.hemisphereLights.value=V.state.hemi,Rt.directionalShadowMap.value=V.state.directionalShadowMap,Rt.directionalShadowMatrix.value=V.state.directionalShadowMatrix,Rt.spotShadowMap.value=V.state.spotShadowMap,Rt.spotLightMatrix.value=V.state.spotLightMatrix,Rt.spotLightMap.value=V.state.spotLightMap,Rt.pointShadowMap.value=V.state.pointShadowMap,Rt.pointShadowMatrix.value=V.state.pointShadowMatrix),J.currentProgram=Gt,J.uniformsList=null,Gt}function n_(A){if(A.uniformsList===null){let k=A.currentProgram.getUniforms();A.uniformsList=Na.seqWithValue(k.seq,A.uniforms)}return A.uniformsList}function i_(A,k){let Z=Dt.get(A);Z.outputColorSpace=k.outputColorSpace,Z.batching=k.batching,Z.batchingColor=k.batchingColor,Z.instancing=k.instancing,Z.instancingColor=k.instancingColor,Z.instancingMorph=k.instancingMorph,Z.skinning=k.skinning,Z.morphTargets=k.morphTargets,Z.morphNormals=k.morphNormals,Z.morphColors=k.morphColors,Z.morphTargetsCount=k.morphTargetsCount,Z.numClippingPlanes=k.numClippingPlanes,Z.numIntersection=k.numClipIntersection,Z.vertexAlphas=k.vertexAlphas,Z.vertexTangents=k.vertexTangents,Z.toneMapping=k.toneMapping}function MA(A,k,Z,J,V){k.isScene!==!0&&(k=pt),I.resetTextureUnits();let dt=k.fog,vt=J.isMeshStandardMaterial?k.environment:null,At=R===null?x.outputColorSpace:R.isXRRenderTarget===!0?R.texture.colorSpace:Ha,Ct=(J.isMeshStandardMaterial?W:T).get(J.envMap||vt),Bt=J.vertexColors===!0&&!!Z.attributes.color&&Z.attributes.color.itemSize===4,Gt=!!Z.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Rt=!!Z.morphAttributes.position,ne=!!Z.morphAttributes.normal,ye=!!Z.morphAttributes.color,xe=as;J.toneMapped&&(R===null||R.isXRRenderTarget===!0)&&(xe=x.toneMapping);let pn=Z.morphAttributes.position||Z.morphAttributes.normal||Z.morphAttributes.color,re=pn!==void 0?pn.length:0,Pt=Dt.get(J),Xi=p.state.lights;if(tt===!0&&(lt===!0||A!==v)){let Un=A===v&&J.id===M;ht.setState(J,A,Un)}let se=!1;J.version===Pt.__version?(Pt.needsLights&&Pt.lightsStateVersion!==Xi.state.version||Pt.outputColorSpace!==At||V.isBatchedMesh&&Pt.batching===!1||!V.isBatchedMesh&&Pt.batching===!0||V.isBatchedMesh&&Pt.batchingColor===!0&&V.colorTexture===null||V.isBatchedMesh&&Pt.batchingColor===!1&&V.colorTexture!==null||V.isInstancedMesh&&Pt.instancing===!1||!V.isInstancedMesh&&Pt.instancing===!0||V.isSkinnedMesh&&Pt.skinning===!1||!V.isSkinnedMesh&&Pt.skinning===!0||V.isInstancedMesh&&Pt.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&Pt.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&Pt.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&Pt.instancingMorph===!1&&V.morphTexture!==null||Pt.envMap!==Ct||J.fog===!0&&Pt.fog!==dt||Pt.numClippingPlanes!==void 0&&(Pt.numClippingPlanes!==ht.numPlanes||Pt.numIntersection!==ht.numIntersection)||Pt.vertexAlphas!==Bt||Pt.vertexTangents!==Gt||Pt.morphTargets!==Rt||Pt.morphNormals!==ne||Pt.morphColors!==ye||Pt.toneMapping!==xe||Pt.morphTargetsCount!==re)&&(se=!0):(se=!0,Pt.__version=J.version);let ni=Pt.currentProgram;se===!0&&(ni=vl(J,k,V));let fo=!1,Sn=!1,Wa=!1,_e=ni.getUniforms(),bi=Pt.uniforms;if(Tt.useProgram(ni.program)&&(fo=!0,Sn=!0,Wa=!0),J.id!==M&&(M=J.id,Sn=!0),fo||v!==A){Tt.buffers.depth.getReversed()?(K.copy(A.projectionMatrix),b4(K),M4(K),_e.setValue(L,"projectionMatrix",K)):_e.setValue(L,"projectionMatrix",A.projectionMatrix),_e.setValue(L,"viewMatrix",A.matrixWorldInverse);let Cr=_e.map.cameraPosition;Cr!==void 0&&Cr.setValue(L,q.setFromMatrixPosition(A.matrixWorld)),Ut.logarithmicDepthBuffer&&_e.setValue(L,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&_e.setValue(L,"isOrthographic",A.isOrthographicCamera===!0),v!==A&&(v=A,Sn=!0,Wa=!0)}if(V.isSkinnedMesh){_e.setOptional(L,V,"bindMatrix"),_e.setOptional(L,V,"bindMatrixInverse");let Un=V.skeleton;Un&&(Un.boneTexture===null&&Un.computeBoneTexture(),_e.setValue(L,"boneTexture",Un.boneTexture,I))}V.isBatchedMesh&&(_e.setOptional(L,V,"batchingTexture"),_e.setValue(L,"batchingTexture",V._matricesTexture,I),_e.setOptional(L,V,"batchingIdTexture"),_e.setValue(L,"batchingIdTexture",V._indirectTexture,I),_e.setOptional(L,V,"batchingColorTexture"),V._colorsTexture!==null&&_e.setValue(L,"batchingColorTexture",V._colorsTexture,I));let $a=Z.morphAttributes;if(($a.position!==void 0||$a.normal!==void 0||$a.color!==void 0)&&It.update(V,Z,ni),(Sn||Pt.receiveShadow!==V.receiveShadow)&&(Pt.receiveShadow=V.receiveShadow,_e.setValue(L,"receiveShadow",V.receiveShadow)),J.isMeshGouraudMaterial&&J.envMap!==null&&(bi.envMap.value=Ct,bi.flipEnvMap.value=Ct.isCubeTexture&&Ct.isRenderTargetTexture===!1?-1:1),J.isMeshStandardMaterial&&J.envMap===null&&k.environment!==null&&(bi.envMapIntensity.value=k.environmentIntensity),Sn&&(_e.setValue(L,"toneMappingExposure",x.toneMappingExposure),Pt.needsLights&&wA(bi,Wa),dt&&J.fog===!0&&mt.refreshFogUniforms(bi,dt),mt.refreshMaterialUniforms(bi,J,z,H,p.state.transmissionRenderTarget[A.id]),Na.upload(L,n_(Pt),bi,I)),J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(Na.upload(L,n_(Pt),bi,I),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&_e.setValue(L,"center",V.center),_e.setValue(L,"modelViewMatrix",V.modelViewMatrix),_e.setValue(L,"normalMatrix",V.normalMatrix),_e.setValue(L,"modelMatrix",V.matrixWorld),J.isShaderMaterial||J.isRawShaderMaterial){let Un=J.uniformsGroups;for(let Cr=0,Rr=Un.length;Cr<Rr;Cr++){let r_=Un[Cr];B.update(r_,ni),B.bind(r_,ni)}}return ni}function wA(A,k){A.ambientLightColor.needsUpdate=k,A.lightProbe.needsUpdate=k,A.directionalLights.needsUpdate=k,A.directionalLightShadows.needsUpdate=k,A.pointLights.needsUpdate=k,A.pointLightShadows.needsUpdate=k,A.spotLights.needsUpdate=k,A.spotLightShadows.needsUpdate=k,A.rectAreaLights.needsUpdate=k,A.hemisphereLights.needsUpdate=k}function SA(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return w},this.getActiveMipmapLevel=function(){return S},this.getRenderTarget=function(){return R},this.setRenderTargetTextures=function(A,k,Z){Dt.get(A.texture).__webglTexture=k,Dt.get(A.depthTexture).__webglTexture=Z;let J=Dt.get(A);J.__hasExternalTextures=!0,J.__autoAllocateDepthBuffer=Z===void 0,J.__autoAllocateDepthBuffer||St.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),J.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(A,k){let Z=Dt.get(A);Z.__webglFramebuffer=k,Z.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(A,k=0,Z=0){R=A,w=k,S=Z;let J=!0,V=null,dt=!1,vt=!1;if(A){let Ct=Dt.get(A);if(Ct.__useDefaultFramebuffer!==void 0)Tt.bindFramebuffer(L.FRAMEBUFFER,null),J=!1;else if(Ct.__webglFramebuffer===void 0)I.setupRenderTarget(A);else if(Ct.__hasExternalTextures)I.rebindTextures(A,Dt.get(A.texture).__webglTexture,Dt.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let Rt=A.depthTexture;if(Ct.__boundDepthTexture!==Rt){if(Rt!==null&&Dt.has(Rt)&&(A.width!==Rt.image.width||A.height!==Rt.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");I.setupDepthRenderbuffer(A)}}let Bt=A.texture;(Bt.isData3DTexture||Bt.isDataArrayTexture||Bt.isCompressedArrayTexture)&&(vt=!0);let Gt=Dt.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(Gt[k])?V=Gt[k][Z]:V=Gt[k],dt=!0):A.samples>0&&I.useMultisampledRTT(A)===!1?V=Dt.get(A).__webglMultisampledFramebuffer:Array.isArray(Gt)?V=Gt[Z]:V=Gt,E.copy(A.viewport),N.copy(A.scissor),U=A.scissorTest}else E.copy(nt).multiplyScalar(z).floor(),N.copy(ct).multiplyScalar(z).floor(),U=ft;if(Tt.bindFramebuffer(L.FRAMEBUFFER,V)&&J&&Tt.drawBuffers(A,V),Tt.viewport(E),Tt.scissor(N),Tt.setScissorTest(U),dt){let Ct=Dt.get(A.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_CUBE_MAP_POSITIVE_X+k,Ct.__webglTexture,Z)}else if(vt){let Ct=Dt.get(A.texture),Bt=k||0;L.framebufferTextureLayer(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,Ct.__webglTexture,Z||0,Bt)}M=-1},this.readRenderTargetPixels=function(A,k,Z,J,V,dt,vt){if(!(A&&A.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let At=Dt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&vt!==void 0&&(At=At[vt]),At){Tt.bindFramebuffer(L.FRAMEBUFFER,At);try{let Ct=A.texture,Bt=Ct.format,Gt=Ct.type;if(!Ut.textureFormatReadable(Bt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Ut.textureTypeReadable(Gt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=A.width-J&&Z>=0&&Z<=A.height-V&&L.readPixels(k,Z,J,V,Xt.convert(Bt),Xt.convert(Gt),dt)}finally{let Ct=R!==null?Dt.get(R).__webglFramebuffer:null;Tt.bindFramebuffer(L.FRAMEBUFFER,Ct)}}},this.readRenderTargetPixelsAsync=async function(A,k,Z,J,V,dt,vt){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let At=Dt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&vt!==void 0&&(At=At[vt]),At){let Ct=A.texture,Bt=Ct.format,Gt=Ct.type;if(!Ut.textureFormatReadable(Bt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Ut.textureTypeReadable(Gt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(k>=0&&k<=A.width-J&&Z>=0&&Z<=A.height-V){Tt.bindFramebuffer(L.FRAMEBUFFER,At);let Rt=L.createBuffer();L.bindBuffer(L.PIXEL_PACK_BUFFER,Rt),L.bufferData(L.PIXEL_PACK_BUFFER,dt.byteLength,L.STREAM_READ),L.readPixels(k,Z,J,V,Xt.convert(Bt),Xt.convert(Gt),0);let ne=R!==null?Dt.get(R).__webglFramebuffer:null;Tt.bindFramebuffer(L.FRAMEBUFFER,ne);let ye=L.fenceSync(L.SYNC_GPU_COMMANDS_COMPLETE,0);return L.flush(),await v4(L,ye,4),L.bindBuffer(L.PIXEL_PACK_BUFFER,Rt),L.getBufferSubData(L.PIXEL_PACK_BUFFER,0,dt),L.deleteBuffer(Rt),L.deleteSync(ye),dt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(A,k=null,Z=0){A.isTexture!==!0&&(ll("WebGLRenderer: copyFramebufferToTexture function signature has changed."),k=arguments[0]||null,A=arguments[1]);let J=Math.pow(2,-Z),V=Math.floor(A.image.width*J),dt=Math.floor(A.image.height*J),vt=k!==null?k.x:0,At=k!==null?k.y:0;I.setTexture2D(A,0),L.copyTexSubImage2D(L.TEXTURE_2D,Z,0,0,vt,At,V,dt),Tt.unbindTexture()},this.copyTextureToTexture=function(A,k,Z=null,J=null,V=0){A.isTexture!==!0&&(ll("WebGLRenderer: copyTextureToTexture function signature has changed."),J=arguments[0]||null,A=arguments[1],k=arguments[2],V=arguments[3]||0,Z=null);let dt,vt,At,Ct,Bt,Gt,Rt,ne,ye,xe=A.isCompressedTexture?A.mipmaps[V]:A.image;Z!==null?(dt=Z.max.x-Z.min.x,vt=Z.max.y-Z.min.y,At=Z.isBox3?Z.max.z-Z.min.z:1,Ct=Z.min.x,Bt=Z.min.y,Gt=Z.isBox3?Z.min.z:0):(dt=xe.width,vt=xe.height,At=xe.depth||1,Ct=0,Bt=0,Gt=0),J!==null?(Rt=J.x,ne=J.y,ye=J.z):(Rt=0,ne=0,ye=0);let pn=Xt.convert(k.format),re=Xt.convert(k.type),Pt;k.isData3DTexture?(I.setTexture3D(k,0),Pt=L.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(I.setTexture2DArray(k,0),Pt=L.TEXTURE_2D_ARRAY):(I.setTexture2D(k,0),Pt=L.TEXTURE_2D),L.pixelStorei(L.UNPACK_FLIP_Y_WEBGL,k.flipY),L.pixelStorei(L.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),L.pixelStorei(L.UNPACK_ALIGNMENT,k.unpackAlignment);let Xi=L.getParameter(L.UNPACK_ROW_LENGTH),se=L.getParameter(L.UNPACK_IMAGE_HEIGHT),ni=L.getParameter(L.UNPACK_SKIP_PIXELS),fo=L.getParameter(L.UNPACK_SKIP_ROWS),Sn=L.getParameter(L.UNPACK_SKIP_IMAGES);L.pixelStorei(L.UNPACK_ROW_LENGTH,xe.width),L.pixelStorei(L.UNPACK_IMAGE_HEIGHT,xe.height),L.pixelStorei(L.UNPACK_SKIP_PIXELS,Ct),L.pixelStorei(L.UNPACK_SKIP_ROWS,Bt),L.pixelStorei(L.UNPACK_SKIP_IMAGES,Gt);let Wa=A.isDataArrayTexture||A.isData3DTexture,_e=k.isDataArrayTexture||k.isData3DTexture;if(A.isRenderTargetTexture||A.isDepthTexture){let bi=Dt.get(A),$a=Dt.get(k),Un=Dt.get(bi.__renderTarget),Cr=Dt.get($a.__renderTarget);Tt.bindFramebuffer(L.READ_FRAMEBUFFER,Un.__webglFramebuffer),Tt.bindFramebuffer(L.DRAW_FRAMEBUFFER,Cr.__webglFramebuffer);for(let Rr=0;Rr<At;Rr++)Wa&&L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Dt.get(A).__webglTexture,V,Gt+Rr),A.isDepthTexture?(_e&&L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Dt.get(k).__webglTexture,V,ye+Rr),L.blitFramebuffer(Ct,Bt,dt,vt,Rt,ne,dt,vt,L.DEPTH_BUFFER_BIT,L.NEAREST)):_e?L.copyTexSubImage3D(Pt,V,Rt,ne,ye+Rr,Ct,Bt,dt,vt):L.copyTexSubImage2D(Pt,V,Rt,ne,ye+Rr,Ct,Bt,dt,vt);Tt.bindFramebuffer(L.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else _e?A.isDataTexture||A.isData3DTexture?L.texSubImage3D(Pt,V,Rt,ne,ye,dt,vt,At,pn,re,xe.data):k.isCompressedArrayTexture?L.compressedTexSubImage3D(Pt,V,Rt,ne,ye,dt,vt,At,pn,xe.data):L.texSubImage3D(Pt,V,Rt,ne,ye,dt,vt,At,pn,re,xe):A.isDataTexture?L.texSubImage2D(L.TEXTURE_2D,V,Rt,ne,dt,vt,pn,re,xe.data):A.isCompressedTexture?L.compressedTexSubImage2D(L.TEXTURE_2D,V,Rt,ne,xe.width,xe.height,pn,xe.data):L.texSubImage2D(L.TEXTURE_2D,V,Rt,ne,dt,vt,pn,re,xe);L.pixelStorei(L.UNPACK_ROW_LENGTH,Xi),L.pixelStorei(L.UNPACK_IMAGE_HEIGHT,se),L.pixelStorei(L.UNPACK_SKIP_PIXELS,ni),L.pixelStorei(L.UNPACK_SKIP_ROWS,fo),L.pixelStorei(L.UNPACK_SKIP_IMAGES,Sn),V===0&&k.generateMipmaps&&L.generateMipmap(Pt),Tt.unbindTexture()},this.copyTextureToTexture3D=function(A,k,Z=null,J=null,V=0){return A.isTexture!==!0&&(ll("WebGLRenderer: copyTextureToTexture3D function signature has changed."),Z=arguments[0]||null,J=arguments[1]||null,A=arguments[2],k=arguments[3],V=arguments[4]||0),ll('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(A,k,Z,J,V)},this.initRenderTarget=function(A){Dt.get(A).__webglFramebuffer===void 0&&I.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?I.setTextureCube(A,0):A.isData3DTexture?I.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?I.setTexture2DArray(A,0):I.setTexture2D(A,0),Tt.unbindTexture()},this.resetState=function(){w=0,S=0,R=null,Tt.reset(),ge.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return wr}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let n=this.getContext();n.drawingBufferColorspace=ee._getDrawingBufferColorSpace(t),n.unpackColorSpace=ee._getUnpackColorSpace()}};var Rh=class extends Dn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ar,this.environmentIntensity=1,this.environmentRotation=new Ar,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,n){return super.copy(t,n),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let n=super.toJSON(t);return this.fog!==null&&(n.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(n.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(n.object.backgroundIntensity=this.backgroundIntensity),n.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(n.object.environmentIntensity=this.environmentIntensity),n.object.environmentRotation=this.environmentRotation.toArray(),n}};var Ih=class extends Nn{constructor(t=null,n=1,i=1,r,s,o,a,c,l=Ln,u=Ln,h,f){super(null,o,a,c,l,u,r,s,h,f),this.isDataTexture=!0,this.image={data:t,width:n,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var za=class extends fs{static get type(){return"LineBasicMaterial"}constructor(t){super(),this.isLineBasicMaterial=!0,this.color=new Kt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ph=new Y,Lh=new Y,_E=new De,cl=new dl,eh=new co,ly=new Y,vE=new Y,px=class extends Dn{constructor(t=new wn,n=new za){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=n,this.updateMorphTargets()}copy(t,n){return super.copy(t,n),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let n=t.attributes.position,i=[0];for(let r=1,s=n.count;r<s;r++)Ph.fromBufferAttribute(n,r-1),Lh.fromBufferAttribute(n,r),i[r]=i[r-1],i[r]+=Ph.distanceTo(Lh);t.setAttribute("lineDistance",new xi(i,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,n){let i=this.geometry,r=this.matrixWorld,s=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),eh.copy(i.boundingSphere),eh.applyMatrix4(r),eh.radius+=s,t.ray.intersectsSphere(eh)===!1)return;_E.copy(r).invert(),cl.copy(t.ray).applyMatrix4(_E);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let y=d,g=m-1;y<g;y+=l){let p=u.getX(y),_=u.getX(y+1),b=nh(this,t,cl,c,p,_);b&&n.push(b)}if(this.isLineLoop){let y=u.getX(m-1),g=u.getX(d),p=nh(this,t,cl,c,y,g);p&&n.push(p)}}else{let d=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let y=d,g=m-1;y<g;y+=l){let p=nh(this,t,cl,c,y,y+1);p&&n.push(p)}if(this.isLineLoop){let y=nh(this,t,cl,c,m-1,d);y&&n.push(y)}}}updateMorphTargets(){let n=this.geometry.morphAttributes,i=Object.keys(n);if(i.length>0){let r=n[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function nh(e,t,n,i,r,s){let o=e.geometry.attributes.position;if(Ph.fromBufferAttribute(o,r),Lh.fromBufferAttribute(o,s),n.distanceSqToSegment(Ph,Lh,ly,vE)>i)return;ly.applyMatrix4(e.matrixWorld);let c=t.ray.origin.distanceTo(ly);if(!(c<t.near||c>t.far))return{distance:c,point:vE.clone().applyMatrix4(e.matrixWorld),index:r,face:null,faceIndex:null,barycoord:null,object:e}}var bE=new Y,ME=new Y,ml=class extends px{constructor(t,n){super(t,n),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let n=t.attributes.position,i=[];for(let r=0,s=n.count;r<s;r+=2)bE.fromBufferAttribute(n,r),ME.fromBufferAttribute(n,r+1),i[r]=r===0?0:i[r-1],i[r+1]=i[r]+bE.distanceTo(ME);t.setAttribute("lineDistance",new xi(i,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var mx=class extends fs{static get type(){return"PointsMaterial"}constructor(t){super(),this.isPointsMaterial=!0,this.color=new Kt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},wE=new De,gx=new dl,ih=new co,rh=new Y,Nh=class extends Dn{constructor(t=new wn,n=new mx){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=n,this.updateMorphTargets()}copy(t,n){return super.copy(t,n),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,n){let i=this.geometry,r=this.matrixWorld,s=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ih.copy(i.boundingSphere),ih.applyMatrix4(r),ih.radius+=s,t.ray.intersectsSphere(ih)===!1)return;wE.copy(r).invert(),gx.copy(t.ray).applyMatrix4(wE);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=i.index,h=i.attributes.position;if(l!==null){let f=Math.max(0,o.start),d=Math.min(l.count,o.start+o.count);for(let m=f,y=d;m<y;m++){let g=l.getX(m);rh.fromBufferAttribute(h,g),SE(rh,g,c,r,t,n,this)}}else{let f=Math.max(0,o.start),d=Math.min(h.count,o.start+o.count);for(let m=f,y=d;m<y;m++)rh.fromBufferAttribute(h,m),SE(rh,m,c,r,t,n,this)}}updateMorphTargets(){let n=this.geometry.morphAttributes,i=Object.keys(n);if(i.length>0){let r=n[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function SE(e,t,n,i,r,s,o){let a=gx.distanceSqToPoint(e);if(a<n){let c=new Y;gx.closestPointToPoint(e,c),c.applyMatrix4(i);let l=r.ray.origin.distanceTo(c);if(l<r.near||l>r.far)return;s.push({distance:l,distanceToRay:Math.sqrt(a),point:c,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var Dh=class extends _i{static get type(){return"RawShaderMaterial"}constructor(t){super(t),this.isRawShaderMaterial=!0}};function sh(e,t,n){return!e||!n&&e.constructor===t?e:typeof t.BYTES_PER_ELEMENT=="number"?new t(e):Array.prototype.slice.call(e)}function gB(e){return ArrayBuffer.isView(e)&&!(e instanceof DataView)}var Va=class{constructor(t,n,i,r){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new n.constructor(i),this.sampleValues=n,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let n=this.parameterPositions,i=this._cachedIndex,r=n[i],s=n[i-1];t:{e:{let o;n:{i:if(!(t<r)){for(let a=i+2;;){if(r===void 0){if(t<s)break i;return i=n.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(s=r,r=n[++i],t<r)break e}o=n.length;break n}if(!(t>=s)){let a=n[1];t<a&&(i=2,s=a);for(let c=i-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===c)break;if(r=s,s=n[--i-1],t>=s)break e}o=i,i=0;break n}break t}for(;i<o;){let a=i+o>>>1;t<n[a]?o=a:i=a+1}if(r=n[i],s=n[i-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return i=n.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,s,r)}return this.interpolate_(i,s,t,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let n=this.resultBuffer,i=this.sampleValues,r=this.valueSize,s=t*r;for(let o=0;o!==r;++o)n[o]=i[s+o];return n}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},yx=class extends Va{constructor(t,n,i,r){super(t,n,i,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ST,endingEnd:ST}}intervalChanged_(t,n,i){let r=this.parameterPositions,s=t-2,o=t+1,a=r[s],c=r[o];if(a===void 0)switch(this.getSettings_().endingStart){case TT:s=t,a=2*n-i;break;case ET:s=r.length-2,a=n+r[s]-r[s+1];break;default:s=t,a=i}if(c===void 0)switch(this.getSettings_().endingEnd){case TT:o=t,c=2*i-n;break;case ET:o=1,c=i+r[1]-r[0];break;default:o=t-1,c=n}let l=(i-n)*.5,u=this.valueSize;this._weightPrev=l/(n-a),this._weightNext=l/(c-i),this._offsetPrev=s*u,this._offsetNext=o*u}interpolate_(t,n,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,m=(i-n)/(r-n),y=m*m,g=y*m,p=-f*g+2*f*y-f*m,_=(1+f)*g+(-1.5-2*f)*y+(-.5+f)*m+1,b=(-1-d)*g+(1.5+d)*y+.5*m,x=d*g-d*y;for(let C=0;C!==a;++C)s[C]=p*o[u+C]+_*o[l+C]+b*o[c+C]+x*o[h+C];return s}},xx=class extends Va{constructor(t,n,i,r){super(t,n,i,r)}interpolate_(t,n,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=(i-n)/(r-n),h=1-u;for(let f=0;f!==a;++f)s[f]=o[l+f]*h+o[c+f]*u;return s}},_x=class extends Va{constructor(t,n,i,r){super(t,n,i,r)}interpolate_(t){return this.copySampleValue_(t-1)}},vi=class{constructor(t,n,i,r){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(n===void 0||n.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=sh(n,this.TimeBufferType),this.values=sh(i,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(t){let n=t.constructor,i;if(n.toJSON!==this.toJSON)i=n.toJSON(t);else{i={name:t.name,times:sh(t.times,Array),values:sh(t.values,Array)};let r=t.getInterpolation();r!==t.DefaultInterpolation&&(i.interpolation=r)}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new _x(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new xx(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new yx(this.times,this.values,this.getValueSize(),t)}setInterpolation(t){let n;switch(t){case fh:n=this.InterpolantFactoryMethodDiscrete;break;case Zy:n=this.InterpolantFactoryMethodLinear;break;case D0:n=this.InterpolantFactoryMethodSmooth;break}if(n===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return console.warn("THREE.KeyframeTrack:",i),this}return this.createInterpolant=n,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return fh;case this.InterpolantFactoryMethodLinear:return Zy;case this.InterpolantFactoryMethodSmooth:return D0}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let n=this.times;for(let i=0,r=n.length;i!==r;++i)n[i]+=t}return this}scale(t){if(t!==1){let n=this.times;for(let i=0,r=n.length;i!==r;++i)n[i]*=t}return this}trim(t,n){let i=this.times,r=i.length,s=0,o=r-1;for(;s!==r&&i[s]<t;)++s;for(;o!==-1&&i[o]>n;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=i.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let t=!0,n=this.getValueSize();n-Math.floor(n)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,r=this.values,s=i.length;s===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==s;a++){let c=i[a];if(typeof c=="number"&&isNaN(c)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(r!==void 0&&gB(r))for(let a=0,c=r.length;a!==c;++a){let l=r[a];if(isNaN(l)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),n=this.values.slice(),i=this.getValueSize(),r=this.getInterpolation()===D0,s=t.length-1,o=1;for(let a=1;a<s;++a){let c=!1,l=t[a],u=t[a+1];if(l!==u&&(a!==1||l!==t[0]))if(r)c=!0;else{let h=a*i,f=h-i,d=h+i;for(let m=0;m!==i;++m){let y=n[h+m];if(y!==n[f+m]||y!==n[d+m]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let h=a*i,f=o*i;for(let d=0;d!==i;++d)n[f+d]=n[h+d]}++o}}if(s>0){t[o]=t[s];for(let a=s*i,c=o*i,l=0;l!==i;++l)n[c+l]=n[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=n.slice(0,o*i)):(this.times=t,this.values=n),this}clone(){let t=this.times.slice(),n=this.values.slice(),i=this.constructor,r=new i(this.name,t,n);return r.createInterpolant=this.createInterpolant,r}};vi.prototype.TimeBufferType=Float32Array;vi.prototype.ValueBufferType=Float32Array;vi.prototype.DefaultInterpolation=Zy;var lo=class extends vi{constructor(t,n,i){super(t,n,i)}};lo.prototype.ValueTypeName="bool";lo.prototype.ValueBufferType=Array;lo.prototype.DefaultInterpolation=fh;lo.prototype.InterpolantFactoryMethodLinear=void 0;lo.prototype.InterpolantFactoryMethodSmooth=void 0;var vx=class extends vi{};vx.prototype.ValueTypeName="color";var bx=class extends vi{};bx.prototype.ValueTypeName="number";var Mx=class extends Va{constructor(t,n,i,r){super(t,n,i,r)}interpolate_(t,n,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(i-n)/(r-n),l=t*a;for(let u=l+a;l!==u;l+=4)us.slerpFlat(s,0,o,l-a,o,l,c);return s}},Uh=class extends vi{InterpolantFactoryMethodLinear(t){return new Mx(this.times,this.values,this.getValueSize(),t)}};Uh.prototype.ValueTypeName="quaternion";Uh.prototype.InterpolantFactoryMethodSmooth=void 0;var uo=class extends vi{constructor(t,n,i){super(t,n,i)}};uo.prototype.ValueTypeName="string";uo.prototype.ValueBufferType=Array;uo.prototype.DefaultInterpolation=fh;uo.prototype.InterpolantFactoryMethodLinear=void 0;uo.prototype.InterpolantFactoryMethodSmooth=void 0;var wx=class extends vi{};wx.prototype.ValueTypeName="vector";var Sx=class{constructor(t,n,i){let r=this,s=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=n,this.onError=i,this.itemStart=function(u){a++,s===!1&&r.onStart!==void 0&&r.onStart(u,o,a),s=!0},this.itemEnd=function(u){o++,r.onProgress!==void 0&&r.onProgress(u,o,a),o===a&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(u){r.onError!==void 0&&r.onError(u)},this.resolveURL=function(u){return c?c(u):u},this.setURLModifier=function(u){return c=u,this},this.addHandler=function(u,h){return l.push(u,h),this},this.removeHandler=function(u){let h=l.indexOf(u);return h!==-1&&l.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=l.length;h<f;h+=2){let d=l[h],m=l[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return m}return null}}},yB=new Sx,Tx=class{constructor(t){this.manager=t!==void 0?t:yB,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(t,n){let i=this;return new Promise(function(r,s){i.load(t,r,n,s)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}};Tx.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ux="\\[\\]\\.:\\/",xB=new RegExp("["+Ux+"]","g"),Fx="[^"+Ux+"]",_B="[^"+Ux.replace("\\.","")+"]",vB=/((?:WC+[\/:])*)/.source.replace("WC",Fx),bB=/(WCOD+)?/.source.replace("WCOD",_B),MB=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Fx),wB=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Fx),SB=new RegExp("^"+vB+bB+MB+wB+"$"),TB=["material","materials","bones","map"],Ex=class{constructor(t,n,i){let r=i||be.parseTrackName(n);this._targetGroup=t,this._bindings=t.subscribe_(n,r)}getValue(t,n){this.bind();let i=this._targetGroup.nCachedObjects_,r=this._bindings[i];r!==void 0&&r.getValue(t,n)}setValue(t,n){let i=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=i.length;r!==s;++r)i[r].setValue(t,n)}bind(){let t=this._bindings;for(let n=this._targetGroup.nCachedObjects_,i=t.length;n!==i;++n)t[n].bind()}unbind(){let t=this._bindings;for(let n=this._targetGroup.nCachedObjects_,i=t.length;n!==i;++n)t[n].unbind()}},be=class e{constructor(t,n,i){this.path=n,this.parsedPath=i||e.parseTrackName(n),this.node=e.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,n,i){return t&&t.isAnimationObjectGroup?new e.Composite(t,n,i):new e(t,n,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(xB,"")}static parseTrackName(t){let n=SB.exec(t);if(n===null)throw new Error("PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:n[2],objectName:n[3],objectIndex:n[4],propertyName:n[5],propertyIndex:n[6]},r=i.nodeName&&i.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=i.nodeName.substring(r+1);TB.indexOf(s)!==-1&&(i.nodeName=i.nodeName.substring(0,r),i.objectName=s)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,n){if(n===void 0||n===""||n==="."||n===-1||n===t.name||n===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(n);if(i!==void 0)return i}if(t.children){let i=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===n||a.uuid===n)return a;let c=i(a.children);if(c)return c}return null},r=i(t.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,n){t[n]=this.targetObject[this.propertyName]}_getValue_array(t,n){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)t[n++]=i[r]}_getValue_arrayElement(t,n){t[n]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,n){this.resolvedProperty.toArray(t,n)}_setValue_direct(t,n){this.targetObject[this.propertyName]=t[n]}_setValue_direct_setNeedsUpdate(t,n){this.targetObject[this.propertyName]=t[n],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,n){this.targetObject[this.propertyName]=t[n],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,n){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=t[n++]}_setValue_array_setNeedsUpdate(t,n){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=t[n++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,n){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=t[n++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,n){this.resolvedProperty[this.propertyIndex]=t[n]}_setValue_arrayElement_setNeedsUpdate(t,n){this.resolvedProperty[this.propertyIndex]=t[n],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,n){this.resolvedProperty[this.propertyIndex]=t[n],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,n){this.resolvedProperty.fromArray(t,n)}_setValue_fromArray_setNeedsUpdate(t,n){this.resolvedProperty.fromArray(t,n),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,n){this.resolvedProperty.fromArray(t,n),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,n){this.bind(),this.getValue(t,n)}_setValue_unbound(t,n){this.bind(),this.setValue(t,n)}bind(){let t=this.node,n=this.parsedPath,i=n.objectName,r=n.propertyName,s=n.propertyIndex;if(t||(t=e.findNode(this.rootNode,n.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let l=n.objectIndex;switch(i){case"materials":if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===l){l=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(l!==void 0){if(t[l]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[r];if(o===void 0){let l=n.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+l+"."+r+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.needsUpdate!==void 0?a=this.Versioning.NeedsUpdate:t.matrixWorldNeedsUpdate!==void 0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!t.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[s]!==void 0&&(s=t.morphTargetDictionary[s])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};be.Composite=Ex;be.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};be.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};be.prototype.GetterByBindingType=[be.prototype._getValue_direct,be.prototype._getValue_array,be.prototype._getValue_arrayElement,be.prototype._getValue_toArray];be.prototype.SetterByBindingTypeAndVersioning=[[be.prototype._setValue_direct,be.prototype._setValue_direct_setNeedsUpdate,be.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[be.prototype._setValue_array,be.prototype._setValue_array_setNeedsUpdate,be.prototype._setValue_array_setMatrixWorldNeedsUpdate],[be.prototype._setValue_arrayElement,be.prototype._setValue_arrayElement_setNeedsUpdate,be.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[be.prototype._setValue_fromArray,be.prototype._setValue_fromArray_setNeedsUpdate,be.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var SW=new Float32Array(1);typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Ax}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Ax);var YE=`
precision highp float;
in vec3 position;      // 0..1 of the box
in float shade;        // 0..1 along the palette
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec3 box;
uniform float radius, pixels;   // of atoms that are not picked; height of the canvas / (2 tan(field of view / 2))
uniform vec2 fog;               // depths between which atoms fade
uniform int picked;
uniform sampler2D palette;
out vec3 colour;
out float faint, ring;
void main() {
    vec4 eye = modelViewMatrix * vec4((position - 0.5) * box, 1.0);
    gl_Position = projectionMatrix * eye;
    ring = gl_VertexID == picked ? 1.0 : 0.0;
    gl_PointSize = 2.0 * mix(radius, 0.62, ring) * pixels / -eye.z;
    colour = texture(palette, vec2(shade * (255.0 / 256.0) + 0.5 / 256.0, 0.5)).rgb;
    faint = 0.62 * smoothstep(fog.x, fog.y, -eye.z);
}`,qE=`
precision mediump float;
in vec3 colour;
in float faint, ring;
uniform vec3 ground, ink;
out vec4 pixel;
void main() {
    vec2 at = gl_PointCoord * 2.0 - 1.0;
    float reach = dot(at, at);
    if (reach > 1.0) discard;
    if (ring * reach > 0.62) { pixel = vec4(ink, 1.0); return; }
    // The light comes from the upper left; its gleam is where the surface mirrors it to the eye.
    float height = sqrt(1.0 - reach);
    float light = 0.42 + 0.58 * max(dot(vec3(at, height), vec3(-0.38, -0.52, 0.765)), 0.0);
    float gleam = max(dot(vec3(at, height), vec3(-0.22, -0.30, 0.928)), 0.0);
    gleam *= gleam;
    gleam *= gleam;
    gleam *= gleam;
    gleam *= gleam;
    pixel = vec4(mix(colour * light + 0.25 * gleam, ground, faint), 1.0);
}`;var Ox=1024,EB=[0,1,1,3,3,2,2,0,4,5,5,7,7,6,6,4,0,4,1,5,2,6,3,7];function AB(){let e=new Uint8Array(1024);for(let n=0;n<256;++n)e.set([...Zr(n/255),255],4*n);let t=new Ih(e,256,1,Pn);return t.needsUpdate=!0,t}function CB(e){let t=Uint32Array.from({length:e},(i,r)=>r),n=12345;for(let i=e-1;i>0;--i){n=Math.imul(n,1664525)+1013904223>>>0;let r=n%(i+1);[t[i],t[r]]=[t[r],t[i]]}return t}var kh=class{constructor(t,n){let i=t.getContext("webgl2",{antialias:!1,alpha:!1,powerPreference:"high-performance"});if(!i)throw new Error("this browser offers no WebGL 2");this.renderer=new Ch({canvas:t,context:i,antialias:!1}),this.canvas=t,this.count=n,this.scene=new Rh,this.camera=new dn,this.geometry=new wn,this.geometry.setAttribute("position",new Ze(new Uint16Array(3*n),3,!0)),this.geometry.setAttribute("shade",new _h(new Uint8Array(n),1,!0)),this.order=CB(n),this.slices=new Uint16Array(n),this.geometry.setIndex(new Ze(this.order.slice(),1)),this.uniforms={box:{value:new Y},radius:{value:.5},pixels:{value:1},fog:{value:new le},picked:{value:-1},palette:{value:AB()},ground:{value:new Kt},ink:{value:new Kt}};let r=new Dh({vertexShader:YE,fragmentShader:qE,glslVersion:hh,uniforms:this.uniforms});this.points=new Nh(this.geometry,r),this.points.frustumCulled=!1,this.edges=new ml(new wn,new za),this.edges.geometry.setIndex(EB),this.trace=new ml(new wn,new za({depthTest:!1})),this.trace.renderOrder=1,this.group=new ss,this.group.add(this.points,this.edges,this.trace),this.scene.add(this.group)}setFrame(t,n){let i=this.geometry.getAttribute("position");i.array.set(t),i.needsUpdate=!0,this.uniforms.box.value.toArray().some((r,s)=>r!==n[s])&&this.setBox(n)}setBox(t){this.uniforms.box.value.fromArray(t);let n=new Float32Array(24);for(let i=0;i<8;++i)for(let r=0;r<3;++r)n[3*i+r]=(i>>r&1?.5:-.5)*t[r];this.edges.geometry.setAttribute("position",new Ze(n,3))}setShades(t){let n=this.geometry.getAttribute("shade");n.array.set(t),n.needsUpdate=!0}setTrace(t){this.trace.geometry.dispose(),this.trace.geometry=new wn,this.trace.geometry.setAttribute("position",new Ze(t,3))}setColours({ground:t,ink:n,edge:i,trace:r}){this.uniforms.ground.value.setStyle(t,"srgb-linear"),this.uniforms.ink.value.setStyle(n,"srgb-linear"),this.scene.background=new Kt(t),this.edges.material.color.set(i),this.trace.material.color.set(r)}sortNearestFirst(t,n){let{array:i}=this.geometry.getAttribute("position"),r=this.geometry.getIndex(),[s,o,a]=t.axes()[2].map((h,f)=>-h*this.uniforms.box.value.getComponent(f)),c=Math.min(0,s)+Math.min(0,o)+Math.min(0,a),l=Ox/65536/(Math.abs(s)+Math.abs(o)+Math.abs(a)),u=new Uint32Array(Ox+1);for(let h=0;h<n;++h){let f=this.order[h],d=Math.floor((s*i[3*f]+o*i[3*f+1]+a*i[3*f+2]-65536*c)*l);this.slices[h]=d,u[d+1]+=1}for(let h=0;h<Ox;++h)u[h+1]+=u[h];for(let h=0;h<n;++h)r.array[u[this.slices[h]]++]=this.order[h];r.needsUpdate=!0}setSize(t,n,i){this.renderer.setPixelRatio(i),this.renderer.setSize(t,n,!1)}draw(t,n){let{width:i,height:r}=this.canvas;t.applyTo(this.camera,i/r);let s=t.distance(i/r);this.uniforms.pixels.value=r/2/Math.tan(this.camera.fov*Math.PI/360),this.uniforms.fog.value.set(s-t.radius*.7,s+t.radius*1.1),this.sortNearestFirst(t,n),this.geometry.setDrawRange(0,n),this.renderer.render(this.scene,this.camera)}};function zh(e,t,{changed:n,click:i}){let r=new Map,s=0,o=0,a=()=>{let[u,h]=[...r.values()];return Math.hypot(u.x-h.x,u.y-h.y)};e.addEventListener("pointerdown",u=>{e.setPointerCapture(u.pointerId),r.set(u.pointerId,{x:u.clientX,y:u.clientY}),r.size===1&&(s=0),r.size===2&&(o=a())}),e.addEventListener("pointermove",u=>{let h=r.get(u.pointerId);if(!h)return;let[f,d]=[u.clientX-h.x,u.clientY-h.y];r.set(u.pointerId,{x:u.clientX,y:u.clientY}),s+=Math.abs(f)+Math.abs(d),r.size===1&&t.turn(-f*.008,d*.008),r.size===2&&o>0&&(t.scale(a()/o),o=a()),n()});let c=u=>{if(!r.delete(u.pointerId))return;let h=e.getBoundingClientRect();u.type==="pointerup"&&s<5&&i(u.clientX-h.left,u.clientY-h.top)};e.addEventListener("pointerup",c),e.addEventListener("pointercancel",c),e.addEventListener("wheel",u=>{document.activeElement===e&&(u.preventDefault(),t.scale(Math.exp(-u.deltaY*.0015)),n())},{passive:!1});let l={ArrowLeft:()=>t.turn(-.1,0),ArrowRight:()=>t.turn(.1,0),ArrowUp:()=>t.turn(0,.1),ArrowDown:()=>t.turn(0,-.1),"+":()=>t.scale(1.15),"=":()=>t.scale(1.15),"-":()=>t.scale(1/1.15),0:()=>t.reset()};e.addEventListener("keydown",u=>{let h=l[u.key];!h||u.ctrlKey||u.metaKey||u.altKey||(u.preventDefault(),h(),n())})}var Bx=32;function RB(e){return Array.from({length:Bx},(t,n)=>{let i=document.createElement("canvas");i.width=i.height=e;let r=i.getContext("2d"),s=Zr(n/(Bx-1)),o=e/2,a=r.createRadialGradient(.68*o,.6*o,.05*o,o,o,o);return a.addColorStop(0,Jr(s.map(c=>Math.min(255,c+70)))),a.addColorStop(.5,Jr(s)),a.addColorStop(1,Jr(s.map(c=>Math.round(c*.45)))),r.fillStyle=a,r.beginPath(),r.arc(o,o,o-.5,0,2*Math.PI),r.fill(),i})}function IB(e,t,n,i){let r=s=>n(...t.map((o,a)=>(s>>a&1?.5:-.5)*o));e.strokeStyle=i,e.lineWidth=1,e.beginPath();for(let s=0;s<8;++s)for(let o of[1,2,4]){if(s&o)continue;let[a,c]=[r(s),r(s|o)];e.moveTo(a[0],a[1]),e.lineTo(c[0],c[1])}e.stroke()}function ZE(e,{positions:t,box:n,shades:i,radius:r},s,o){let a=e.getContext("2d"),{width:c,height:l}=e,u=s.projection(c,l);a.fillStyle=o.ground,a.fillRect(0,0,c,l),IB(a,n,u,o.edge);let h=[];for(let d=0;d<i.length;++d){let m=[0,1,2].map(b=>(t[3*d+b]/65536-.5)*n[b]),[y,g,p,_]=u(...m);_>0&&h.push([p,y,g,r*_,i[d]])}h.sort((d,m)=>m[0]-d[0]);let f=RB(64);for(let[,d,m,y,g]of h)a.drawImage(f[Math.round(g/255*(Bx-1))],d-y,m-y,2*y,2*y)}var Vh=.5,PB=.16,LB=/swiftshader|llvmpipe|software|basic render/i;function JE(){let e=getComputedStyle(document.documentElement),t=n=>e.getPropertyValue(n).trim();return{ground:t("--stage"),ink:t("--ink"),edge:t("--edge"),trace:el(1)}}var kx=class{constructor(t,n,i){this.data=t,this.atoms=n,this.title=i,this.picked=-1,this.colour=n.colours[0];let r=n.box(0);this.camera=new da(.46*Math.hypot(...r)+Vh),this.canvas=D("canvas",{}),this.stage=D("div",{class:"stage",tabindex:0,role:"application","aria-roledescription":"three-dimensional view","aria-label":`Atoms of ${i}. Arrow keys turn, plus and minus zoom, 0 resets.`},this.canvas),this.thin=D("p",{class:"thin","aria-hidden":"true"}),this.info=D("p",{class:"picked","aria-live":"polite"}),this.playback=new pa(n.frames,n.times,jt(t.time_unit??"tau"),8),this.node=this.layout(),this.begin()}layout(){let{colours:t,count:n}=this.atoms;this.choice=D("select",{id:ho("colour")},t.map(r=>D("option",{value:r.name},r.name.replaceAll("_"," ")))),this.choice.addEventListener("change",()=>this.setColour(t.find(r=>r.name===this.choice.value))),this.legend=D("div",{class:"legend"}),this.boxSwitch=D("input",{type:"checkbox",checked:!0}),this.boxSwitch.addEventListener("change",()=>this.redraw()),this.traceSwitch=D("input",{type:"checkbox"}),this.traceSwitch.addEventListener("change",()=>this.select(this.picked<0?0:this.picked)),this.atomField=D("input",{id:ho("atom"),type:"number",min:0,step:1,placeholder:"click one"}),this.atomField.addEventListener("change",()=>this.select(this.atomField.value===""?-1:this.placeOf(Number(this.atomField.value))));let i=D("canvas",{class:"print-only",width:1200,height:900,role:"img","aria-label":`Atoms of ${this.title}`});return window.addEventListener("beforeprint",()=>this.drawStillOn(i,{ground:"#ffffff",edge:"#9aa3ad"})),this.controls=D("div",{class:"controls"},D("span",{},D("label",{for:this.choice.id},"Colour "),this.choice),D("label",{class:"live"},this.boxSwitch," Box"),D("span",{class:"live"},D("label",{for:this.atomField.id},"Atom "),this.atomField),D("label",{class:"live"},this.traceSwitch," Trace"),D("button",{type:"button",class:"small live",onclick:()=>{this.camera.reset(),this.moved()}},"Reset view"),D("button",{type:"button",class:"small",onclick:()=>this.savePicture()},"PNG")),D("div",{class:"viewer"},D("div",{class:"stage-frame"},this.stage,this.thin),i,this.playback.node,this.controls,this.legend,this.info,D("p",{class:"caption"},this.data.words?`${jt(this.data.words)} `:null,`${ce(n)} atoms, ${this.atoms.frames} ${this.atoms.frames===1?"frame":"frames"}.`))}begin(){try{this.scene=new kh(this.canvas,this.atoms.count)}catch(t){this.fallBack(`The atoms cannot be turned here: ${t.message}. This is a still picture.`)}this.scene&&this.goLive(),this.playback.onTime(()=>this.showFrame()),document.addEventListener("themechange",()=>{this.recolour(),this.redraw()}),new ResizeObserver(()=>this.resize()).observe(this.stage),this.recolour(),this.setColour(this.colour),this.showFrame()}goLive(){let t=this.scene.renderer.getContext(),n=t.getExtension("WEBGL_debug_renderer_info");this.software=LB.test(n?t.getParameter(n.UNMASKED_RENDERER_WEBGL):""),this.pace=new Nf(t,this.atoms.count,i=>this.draw(i)),this.playback.ready=()=>!this.pace.busy,zh(this.stage,this.camera,{changed:()=>this.moved(),click:(i,r)=>this.pickAt(i,r)}),this.canvas.addEventListener("webglcontextlost",i=>{i.preventDefault(),this.fallBack("The graphics processor has stopped drawing. This is a still picture; load the page again to turn it."),this.resize()})}fallBack(t){this.scene=this.pace=null,this.playback.ready=()=>!0;let n=D("canvas",{});this.canvas.replaceWith(n),this.canvas=n,this.node.classList.add("still"),this.stage.setAttribute("role","img"),this.stage.removeAttribute("tabindex"),this.stage.removeAttribute("aria-roledescription"),this.stage.setAttribute("aria-label",`Atoms of ${this.title}, a still picture`),this.node.prepend(D("p",{class:"why"},t))}positions(){let{frame:t}=this.playback;return this.atoms.positions.subarray(3*t*this.atoms.count,3*(t+1)*this.atoms.count)}showFrame(){let{frame:t}=this.playback;this.scene&&(this.scene.setFrame(this.positions(),this.atoms.box(t)),this.scene.setShades(Lf(this.colour,t,this.atoms.count))),this.describePicked(),this.playback.playing&&this.pace?(this.pace.moved(),this.pace.drawNow()):this.redraw(),this.canvas.dataset.frame=t}setColour(t){this.colour=t,this.legend.replaceChildren(Pf(t.low,t.high,jt(t.label))),this.showFrame()}recolour(){this.scene?.setColours(JE())}resize(){let{clientWidth:t,clientHeight:n}=this.stage;t===0||n===0||(this.scene?this.scene.setSize(t,n,this.software?1:Math.min(window.devicePixelRatio,2)):(this.canvas.width=t*Math.min(window.devicePixelRatio,2),this.canvas.height=n*Math.min(window.devicePixelRatio,2)),this.redraw())}moved(){this.pace?this.pace.moved():this.redraw()}redraw(){this.scene?this.pace.changed():this.drawStillOn(this.canvas,JE())}draw(t){this.scene&&(this.scene.edges.visible=this.boxSwitch.checked,this.scene.trace.visible=this.traceSwitch.checked&&this.picked>=0,this.scene.uniforms.radius.value=this.scene.trace.visible?PB:Vh,this.scene.draw(this.camera,t),this.canvas.dataset.drawn=t,this.thin.textContent=t<this.atoms.count?`while moving: ${ce(t)} of ${ce(this.atoms.count)} atoms are drawn`:"")}drawStillOn(t,n){let{frame:i}=this.playback;ZE(t,{positions:this.positions(),box:this.atoms.box(i),shades:Lf(this.colour,i,this.atoms.count),radius:Vh},this.camera,n)}pickAt(t,n){let{clientWidth:i,clientHeight:r}=this.stage;this.select(xT(this.positions(),this.atoms.box(this.playback.frame),Vh,this.camera.projection(i,r),t,n))}idOf(t){return this.atoms.ids?this.atoms.ids[t]:t}placeOf(t){return this.atoms.ids?this.atoms.ids.indexOf(t):Number.isInteger(t)&&t>=0&&t<this.atoms.count?t:-1}select(t){this.picked=t,this.atomField.value=t<0?"":String(this.idOf(t)),this.scene&&(this.scene.uniforms.picked.value=t,t>=0&&this.scene.setTrace(_T(this.atoms,t))),this.describePicked(),this.redraw()}describePicked(){if(this.picked<0){this.info.textContent="";return}let{frame:t}=this.playback,n=this.atoms.colours.filter(i=>!i.still).map(i=>{let r=Lf(i,t,this.atoms.count)[this.picked]/255;return`${jt(i.label||i.name)}: ${ce(i.low+r*(i.high-i.low),3)}`});this.info.textContent=[`Atom ${this.idOf(this.picked)}`,...n].join("  ·  ")}savePicture(){this.scene&&this.scene.draw(this.camera,this.atoms.count),this.canvas.toBlob(t=>ps(ii(`${this.title}-atoms`,".png"),t))}};function KE(e,t){let n=yT(e);return n?new kx(e,n,t):null}var NB=.12,zx=12;function DB(e){let t=[0,1,2].map(n=>{let i=e.filter((a,c)=>c%3===n).sort(),r=a=>i[Math.round(a*(i.length-1))],[s,o]=[r(.02),r(.98)];return{middle:(s+o)/2,half:(o-s)/2}});return{middle:t.map(n=>n.middle),radius:1.12*Math.hypot(...t.map(n=>n.half))||1,flat:t[2].half<1e-9*t[0].half}}var Vx=class{constructor(t,n,i){this.bodies=t.bodies,this.positions=n,this.count=t.bodies.length,this.frames=Math.floor(n.length/(3*this.count)),this.title=i;let{middle:r,radius:s,flat:o}=DB(n);this.middle=r,this.camera=new da(s,o?{azimuth:0,elevation:0}:void 0),this.canvas=D("canvas",{}),this.stage=D("div",{class:"stage",tabindex:0,role:"application","aria-roledescription":"three-dimensional view","aria-label":`Tracks of ${i}. Arrow keys turn, plus and minus zoom, 0 resets.`},this.canvas),this.playback=new pa(this.frames,t.times??[],jt(t.time_unit??""),20);let a=D("canvas",{class:"print-only",width:1200,height:900,role:"img","aria-label":`Tracks of ${i}`});window.addEventListener("beforeprint",()=>this.paint(a,1.5,{ground:"#ffffff",ink:"#1a1d21"})),this.node=D("div",{class:"viewer"},D("div",{class:"stage-frame"},this.stage),a,this.playback.node,D("div",{class:"controls"},D("button",{type:"button",class:"small",onclick:()=>{this.camera.reset(),this.redraw()}},"Reset view"),D("button",{type:"button",class:"small",onclick:()=>this.canvas.toBlob(c=>ps(ii(`${i}-tracks`,".png"),c))},"PNG")),t.words?D("p",{class:"caption"},jt(t.words)):null),zh(this.stage,this.camera,{changed:()=>this.redraw(),click:()=>{}}),this.playback.onTime(()=>this.redraw()),document.addEventListener("themechange",()=>this.redraw()),new ResizeObserver(()=>this.redraw()).observe(this.stage)}redraw(){this.wanted||(this.wanted=!0,requestAnimationFrame(()=>{this.wanted=!1;let t=Math.min(window.devicePixelRatio,2),[n,i]=[this.stage.clientWidth*t,this.stage.clientHeight*t];if(n===0)return;(this.canvas.width!==n||this.canvas.height!==i)&&Object.assign(this.canvas,{width:n,height:i});let r=getComputedStyle(document.documentElement);this.paint(this.canvas,t,{ground:r.getPropertyValue("--stage").trim(),ink:r.getPropertyValue("--ink").trim()}),this.canvas.dataset.frame=this.playback.frame}))}line(t,n,i,r,s){t.beginPath();for(let o=r;o<=s;++o){let[a,c]=n(o,i);o===r?t.moveTo(a,c):t.lineTo(a,c)}t.stroke()}paint(t,n,{ground:i,ink:r}){let s=t.getContext("2d"),o=this.camera.projection(t.width,t.height),a=(u,h)=>{let f=3*(u*this.count+h);return o(...[0,1,2].map(d=>this.positions[f+d]-this.middle[d]))},c=this.playback.frame,l=Math.max(2,Math.round(NB*this.frames));s.fillStyle=i,s.fillRect(0,0,t.width,t.height),s.lineJoin=s.lineCap="round",this.bodies.forEach((u,h)=>{s.strokeStyle=el(h%8),s.globalAlpha=.3,s.lineWidth=n,this.line(s,a,h,0,this.frames-1),s.lineWidth=2.6*n;for(let f=0;f<zx;++f){let[d,m]=[f,f+1].map(y=>Math.max(0,Math.round(c-l+l*y/zx)));s.globalAlpha=(f+1)/zx,m>d&&this.line(s,a,h,d,m)}s.globalAlpha=1}),this.bodiesNow(s,u=>a(c,u),n,r,i)}bodiesNow(t,n,i,r,s){let o=Math.max(...this.bodies.map(c=>c.mass??1))||1;t.font=`600 ${13*i}px system-ui, sans-serif`;let a=this.bodies.map((c,l)=>({body:c,place:l,at:n(l)})).sort((c,l)=>l.at[2]-c.at[2]);for(let{body:c,place:l,at:[u,h]}of a){let f=i*(4.5+6.5*Math.cbrt((c.mass??1)/o)),d=el(l%8),m=t.createRadialGradient(u-.35*f,h-.4*f,.1*f,u,h,f);m.addColorStop(0,`color-mix(in srgb, ${d} 45%, white)`),m.addColorStop(.55,d),m.addColorStop(1,`color-mix(in srgb, ${d} 65%, black)`),t.fillStyle=m,t.beginPath(),t.arc(u,h,f,0,2*Math.PI),t.fill(),t.strokeStyle=s,t.lineWidth=4*i,t.fillStyle=r,t.strokeText(c.name??"",u+f+4*i,h-f),t.fillText(c.name??"",u+f+4*i,h-f)}}};function QE(e,t){let n=gT(e.positions??"");return n.length>=3*(e.bodies?.length??0)&&e.bodies?.length>0?new Vx(e,n,t):null}function tA(e){let t={id:"tracks-energy-error",title:"Energy error",lead:!0,cursor:!0,caption:"Relative error of the energy at the time of each frame. The line follows the playback; click to go to a time.",x:{label:e.time_unit?`t / ${e.time_unit}`:"t"},y:{label:"energy error"},marks:[{type:"line",table:"tracks-energy-error",x:"time",y:"energy_error",colour:0}]},n={name:"tracks-energy-error",title:"Energy error along the tracks",columns:[{name:"time"},{name:"energy_error"}],values:[e.times,e.energy_error]};return{chart:t,table:n}}function Hx(e,t,n,i){if(!n)return null;let r=D("pre",{tabindex:0,role:"region","aria-label":e},n);return D("details",{open:!!i},D("summary",{},e),r,D("p",{class:"buttons"},a_("Copy",r),po("Save",t,()=>n)))}function eA(e,t,n){let i=e.downloads??{},s=[...(e.tables??[]).map(o=>({label:o.title||o.name,name:ii(o.file||o.name,".csv"),make:()=>Rf(o),type:"text/csv"})),...t.map(o=>({label:o.title,name:ii(o.id,".svg"),make:o.svg,type:"image/svg+xml"}))];return s.length===0&&!i.methods&&!i.deck&&!i.bibtex?null:Fe("Downloads",n,Hx("Methods, as a paragraph to paste","methods.txt",i.methods,!0),Hx("References (BibTeX)","references.bib",i.bibtex),Hx("The deck as used","deck.toml",i.deck),s.length>0&&D("ul",{class:"files"},s.map(o=>D("li",{},D("button",{type:"button",class:"file",onclick:()=>ps(o.name,o.make(),o.type)},D("span",{class:"ending"},o.name.slice(o.name.lastIndexOf(".")+1).toUpperCase())," ",D("bdi",{},o.label))))))}var iA={good:{sign:"✓",words:"good"},doubt:{sign:"!",words:"in doubt"},bad:{sign:"✕",words:"bad"},unknown:{sign:"?",words:"not known"}},nA=["good","unknown","doubt","bad"],UB={run:"Molecular dynamics run","few-body":"Few bodies",sweep:"Sweep",reference:"Reference values",reproduction:"Reproduction",comparison:"Comparison",set:"Runs compared"},Hh=e=>Object.hasOwn(iA,e)?e:"unknown";function Gx(e){let{sign:t,words:n}=iA[Hh(e)];return D("span",{class:`sign ${Hh(e)}`,role:"img","aria-label":n},t)}function rA(e){return e.map(t=>Hh(t.level)).reduce((t,n)=>nA.indexOf(n)>nA.indexOf(t)?n:t,"good")}function sA(e){let t=e.state??"";return D("div",{class:"hero"},D("p",{class:"kind"},UB[e.kind]??"Report",t&&D("span",{class:`state ${/^[a-z]+$/.test(t)?t:""}`},t)),D("h1",{},D("bdi",{},e.title||e.source||"ljmd report")),e.state_words&&D("p",{class:"state-words"},jt(e.state_words)),e.source&&D("p",{class:"source"},D("code",{},D("bdi",{},e.source))))}function FB(e){return D("ul",{class:"verdict"},e.map(t=>D("li",{class:Hh(t.level)},Gx(t.level),D("div",{},t.subject&&D("strong",{},t.subject),D("p",{},jt(t.words))))))}function OB(e){return D("ul",{class:"warnings"},e.map(t=>D("li",{},jt(t))))}function oA(e,t){let n=e.verdict??[],i=e.warnings??[];return n.length+i.length===0?null:Fe("Verdict",t,n.length>0&&FB(n),i.length>0&&OB(i))}function Wh(e){return e.text?jt(e.text):Ir(e.value,e.error)}function Gh(e){return e.si_text?jt(e.si_text):e.si_value===null||e.si_value===void 0?"":Ir(e.si_value,e.si_error)}var xl=e=>e&&e!=="1"&&D("span",{class:"unit"},Yi(e)),aA=e=>String(e??"").replaceAll("_"," "),Wx=["temperature","potential_energy","pressure","density","diffusion","viscosity"];function BB(e){let t=e.filter(i=>i.lead);if(t.length>0)return t;let n=i=>Wx.includes(i.name)?Wx.indexOf(i.name):Wx.length;return e.filter(i=>i.error>0).sort((i,r)=>n(i)-n(r)).slice(0,4)}function kB(e){let[t,n]=Wh(e).split(" ± ");return D("span",{class:"value"},D("span",{},t),n?D("span",{class:"error"},` ± ${n}`):null,e.mark?D("sup",{},e.mark):null)}function zB(e){let t=Gh(e);return D("li",{},D("span",{class:"name"},aA(e.name),e.symbol&&D("i",{}," ",Yi(e.symbol))),kB(e),D("span",{class:"below"},xl(e.unit),t&&xl(e.unit)&&" · ",t&&D("span",{},t," ",xl(e.si_unit))))}function VB(e){let t=e.reference;if(!t)return null;let n=(e.value-t.value)/Math.hypot(e.error??NaN,t.error??0);return D("span",{},t.text?jt(t.text):Ir(t.value,t.error),D("span",{class:"unit from"},[t.label,Number.isFinite(n)?`${ce(n,2)} errors away`:null].filter(Boolean).join(", ")))}function HB(e,t){return D("tr",{},D("th",{scope:"row"},aA(e.name),e.symbol&&D("i",{}," ",Yi(e.symbol))),D("td",{},Wh(e)," ",xl(e.unit),e.mark&&D("sup",{},e.mark)),t.si&&D("td",{},Gh(e)," ",Gh(e)&&xl(e.si_unit)),t.samples&&D("td",{},e.samples===void 0||e.samples===null?"":ce(Math.round(e.samples))),t.reference&&D("td",{},VB(e)))}function cA(e,t){let n=e.quantities??[];if(n.length===0)return null;let i={si:n.some(a=>Gh(a)!==""),samples:n.some(a=>a.samples!==void 0&&a.samples!==null),reference:n.some(a=>a.reference)},r=["Quantity",e.kind==="few-body"?"Value, in the deck's units":"Reduced units",i.si&&"SI",i.samples&&"Independent samples",i.reference&&"Reference"],s=D("table",{class:"results"},D("thead",{},D("tr",{},r.filter(Boolean).map(a=>D("th",{scope:"col"},a)))),D("tbody",{},n.map(a=>HB(a,i)))),o=BB(n);return Fe("Results",t,o.length>0&&D("ul",{class:"cards"},o.map(zB)),ds("Results",s),(e.footnotes??[]).length>0&&D("ul",{class:"footnotes"},e.footnotes.map(a=>D("li",{},a))))}var $x=8;function GB(e,t){let n=Math.hypot(e?.error??NaN,t?.error??NaN);return n>0&&Number.isFinite(e.value)&&Number.isFinite(t.value)?(e.value-t.value)/n:null}function WB(e,t,n){if(!e)return D("td",{},"–");let i=n?null:GB(e,t);return D("td",{class:i!==null&&Math.abs(i)>3?"apart":null},Wh(e),i===null?null:D("span",{class:"unit"},` ${i>0?"+":""}${ce(i,2)} errors`))}function lA(e,t){let n=e.map(a=>a.payload),i=[...new Set(n.flatMap(a=>(a.quantities??[]).map(c=>c.name)))];if(i.length===0)return null;let r=(a,c)=>(a.quantities??[]).find(l=>l.name===c),s=i.map(a=>{let c=n.map(u=>r(u,a)),l=c.find(Boolean);return D("tr",{},D("th",{scope:"row"},a.replaceAll("_"," ")," ",l.unit&&l.unit!=="1"?D("span",{class:"unit"},Yi(l.unit)):null),c.map((u,h)=>WB(u,c[0],h===0)))}),o=D("table",{class:"results"},D("thead",{},D("tr",{},D("th",{scope:"col"},"Quantity"),e.map(a=>D("th",{scope:"col"},D("bdi",{},a.label))))),D("tbody",{},s));return Fe("Results side by side",t,D("p",{class:"caption"},"Differences are from the first run, in combined standard errors; more than three are marked."),ds("Results side by side",o))}var Xx=e=>`${e.x?.label}|${e.y?.label}`;function $B(e,t){let n=r=>t.values[t.columns.findIndex(s=>s.name===r)]??[],i=n(e.y);return n(e.x).filter((r,s)=>r!==null&&i[s]!==null).length>1}function uA(e,t){let n=new Map,i=[],r=e.length>$x?`The first ${$x} of ${e.length} runs.`:"";return e.slice(0,$x).forEach((s,o)=>{for(let a of s.payload.charts??[]){let c=a.marks?.find(f=>["line","dots","steps"].includes(f.type)&&!f.group),l=c&&(s.payload.tables??[]).find(f=>f.name===c.table);if(!l||!$B(c,l)||t.some(f=>Xx(f)===Xx(a)))continue;let u=`${o}/${l.name}`;i.some(f=>f.name===u)||i.push({...l,name:u});let h=`${a.id}|${Xx(a)}`;n.has(h)||n.set(h,{...a,id:`compared-${a.id}`,caption:r,note:"",marks:[]}),n.get(h).marks.push({...c,table:u,colour:o,label:s.label})}}),{charts:[...n.values()].filter(s=>s.marks.length>1),tables:i}}function fA(e,t,n){return Fe("The runs",t,e.map(i=>{let r=D("div",{class:"member"}),s=D("details",{},D("summary",{},Gx(rA(i.payload.verdict??[]))," ",D("strong",{},D("bdi",{},i.label))," ",D("bdi",{},i.payload.title??"")),r);return s.addEventListener("toggle",()=>{s.open&&!r.hasChildNodes()&&r.append(...n(i.payload))}),s}))}function XB(e){return`./${String(e).split("/").filter(n=>n!==""&&n!==".").map(n=>n===".."?"..":encodeURIComponent(n)).join("/")}`}function hA(e){let t=D("bdi",{},jt(e.label));return D("li",{class:/^[a-z]+$/.test(e.state??"")?e.state:null},e.href?D("a",{href:XB(e.href)},t):t,e.state?D("span",{class:"state"},e.state):null,e.words?D("p",{},jt(e.words)):null,e.directory&&!e.href?D("code",{},D("bdi",{},e.directory)):null)}function dA(e,t,n="Points"){if(e.length===0)return null;let i=e.filter(s=>s.state&&s.state!=="finished"),r=e.filter(s=>!i.includes(s));return Fe(n,t,i.length>0?[D(`h${t+1}`,{},`${i.length} of ${e.length} did not finish`),D("ul",{class:"points"},i.map(hA))]:null,r.length>0?D("details",{open:r.length<=12},D("summary",{},`${r.length} finished`),D("ul",{class:"points"},r.map(hA))):null)}var pA=100;function YB(e){let t=new Map(e.columns.filter(n=>n.error_of).map(n=>[n.error_of,n.name]));return e.columns.filter(n=>!n.error_of&&n.name!==e.flag).map(n=>({...n,values:ha(e,n.name),errors:t.has(n.name)?ha(e,t.get(n.name)):null}))}function qB(e,t){let n=e.values[t];return typeof n=="boolean"?n?"yes":"no":typeof n=="string"?D("bdi",{},n):e.errors?.[t]>0?Ir(n,e.errors[t]):ce(n)}function ZB(e,t){return e===t?0:e==null?1:t==null?-1:typeof e=="string"?e.localeCompare(String(t),"en",{numeric:!0}):e-t}function JB(e,t){let n=YB(e),i=e.flag?ha(e,e.flag):[],r=Array.from({length:Cf(e)},(c,l)=>l),s=D("tbody"),o=()=>{s.replaceChildren(...r.slice(0,e.lead?r.length:pA).map(c=>D("tr",{class:i[c]?"suspect":null},n.map((l,u)=>{let h=typeof l.values[c]=="string";return D("td",{class:h?"text":null},qB(l,c),u===0&&i[c]?D("span",{class:"flag"},"suspect"):null)}))))},a=n.map(c=>{let l=D("th",{scope:"col",class:c.values.some(h=>typeof h=="string")?"text":null}),u=D("button",{type:"button",class:"sort"},Yi(c.label||c.name),c.unit&&c.unit!=="1"?D("span",{class:"unit"},Yi(c.unit)):null);return u.addEventListener("click",()=>{let h=l.getAttribute("aria-sort")==="ascending";a.forEach(f=>f.removeAttribute("aria-sort")),l.setAttribute("aria-sort",h?"descending":"ascending"),r.sort((f,d)=>(h?-1:1)*ZB(c.values[f],c.values[d])||f-d),o()}),l.append(u),l});return o(),ds(t,D("table",{},D("thead",{},D("tr",{},a)),s))}function KB(e){let t=Cf(e),n=Math.max(e.rows??t,t),i=e.lead?t:Math.min(t,pA),r=[`${ce(n)} rows`];return t<n&&r.push(`${ce(t)} of them are in this page${e.file?`, all in ${e.file}`:""}`),i<t&&r.push(`the first ${i} are shown`),r.join("; ")}function jB(e){let t=e.title||e.name,n=D("div"),i=D("details",{open:!!e.lead,class:"table"},D("summary",{},D("bdi",{},t),D("span",{class:"unit"},KB(e))),n),r=()=>{!i.open||n.hasChildNodes()||n.append(JB(e,t),po("Save as CSV",ii(e.file||e.name,".csv"),()=>Rf(e),"text/csv"))};return i.addEventListener("toggle",r),r(),i}function mA(e,t,n="Tables"){return e.length>0?Fe(n,t,e.map(jB)):null}function gA(e,t){return ds(t,D("table",{class:"pairs"},D("tbody",{},e.map(([n,i])=>D("tr",{},D("th",{scope:"row"},jt(String(n).replaceAll("_"," "))),D("td",{class:"text"},D("bdi",{},typeof i=="number"?ce(i,17):String(i??"–"))))))))}function QB(e,t,n){let i=e.title||e.source||"the run",r=e.tracks?QE(e.tracks,i):null;if(r&&e.tracks.energy_error?.length>0&&!t.some(o=>o.lead&&qx(o).cursor)){let{chart:o,table:a}=tA(e.tracks);t.unshift(o),n.push(a)}let s=e.atoms?KE(e.atoms,i):null;return{tracks:r,atoms:s,playback:(r??s)?.playback??null}}function qx(e){return{...e,cursor:e.cursor??/^t( \/|$)/.test(e.x?.label??"")}}function tk(e){return e&&{get time(){return e.time},onTime:t=>e.onTime(t),seek:t=>e.seek(t)}}function Yx(e){return e.length>0?D("div",{class:"charts"},e.map(t=>t.node)):null}function Zx(e,t=2){let n=e.members??[],i=uA(n,e.charts??[]),r=[...e.charts??[],...i.charts],s=[...e.tables??[]],{tracks:o,atoms:a,playback:c}=QB(e,r,s),l=new Map([...s,...i.tables].map(_=>[_.name,_])),u=r.map(_=>({chart:_,...dT(qx(_),l,tk(c),t+1)})),h=u.filter(({chart:_})=>_.lead),f=u.filter(({chart:_})=>!_.lead),d=[...Object.entries(e.program??{}),...e.provenance??[]],m=o?h.filter(({chart:_})=>qx(_).cursor):[],y=h.filter(_=>!m.includes(_)),g=e.kind!=="run"&&y.length>0;return[oA(e,t),o&&Fe("Playback",t,D("div",{class:"linked"},o.node,Yx(m))),n.length>0&&lA(n,t),g&&Fe("Overview",t,Yx(y)),cA(e,t),(f.length>0||y.length>0&&!g)&&Fe("Charts",t,Yx(g?f:[...y,...f])),a&&Fe("Atoms",t,a.node),dA(e.points??[],t,e.kind==="reference"?"Runs":"Points"),n.length>0&&fA(n,t,_=>Zx(_,t+1)),mA(s,t),d.length>0&&Fe("Provenance",t,gA(d,"Provenance")),eA({...e,tables:s},u,t)].filter(Boolean)}var yA=window.matchMedia("(prefers-color-scheme: dark)"),xA=null;function _A(){return(xA??(yA.matches?"dark":"light"))==="dark"}function Jx(e){let t=_A();document.documentElement.dataset.theme=t?"dark":"light",e.setAttribute("aria-pressed",String(t)),document.dispatchEvent(new CustomEvent("themechange"))}function vA(){let e=D("button",{type:"button",class:"theme","aria-label":"Dark colours"},D("span",{class:"theme-icon","aria-hidden":"true"}));return e.addEventListener("click",()=>{xA=_A()?"light":"dark",Jx(e)}),yA.addEventListener("change",()=>Jx(e)),Jx(e),e}var bA=1;function ek(e){return D("nav",{"aria-label":"Sections"},D("ul",{},e.map(t=>{let n=t.querySelector("h2");return D("li",{},D("a",{href:`#${n.id}`},n.textContent))})))}function nk(e){document.title=`${e.title||e.source||"report"} · ljmd`;let t=vA(),n=Zx(e);document.getElementById("page").append(D("a",{class:"skip",href:"#content"},"Skip to the content"),D("header",{},D("div",{class:"bar"},D("span",{class:"brand"},"ljmd"),ek(n),t)),D("main",{id:"content",tabindex:-1},sA(e),n),D("footer",{},D("p",{},"Made by ",D("code",{},"ljmd report"),". This file needs no network; it can be sent and archived as it is. Charts by Observable Plot, atoms by three.js; their licences are in the source of this page.")))}function ik(e){throw document.getElementById("page").replaceChildren(D("main",{},D("h1",{},"This report cannot be shown"),D("p",{class:"why"},e.message))),e}try{let e=JSON.parse(document.getElementById("ljmd-data").textContent);if(e.format!=="ljmd-report")throw new Error("The data in this page are not those of a report.");if(e.version>bA)throw new Error(`The data have version ${e.version}; this page knows version ${bA}.`);nk(e),document.documentElement.dataset.ready="true"}catch(e){ik(e)}})();
