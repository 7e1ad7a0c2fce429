/*! Contains three.js.

The MIT License

Copyright (c) 2010-2026 three.js authors

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
(()=>{var Li={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Di={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Hd=0,kl=1,Wd=2;var Br=1,Xd=2,Os=3,Ni=0,hn=1,ke=2,Ki=0,Us=1,Gl=2,Vl=3,Hl=4,qd=5;var ji=100,$d=101,Yd=102,Zd=103,Jd=104,Kd=200,jd=201,Qd=202,tf=203,Wl=204,Xl=205,ef=206,nf=207,sf=208,rf=209,of=210,af=211,cf=212,lf=213,hf=214,Wo=0,Xo=1,qo=2,Es=3,$o=4,Yo=5,Zo=6,Jo=7,wa=0,uf=1,df=2,Yn=0,ql=1,$l=2,Yl=3,Zl=4,Jl=5,Kl=6,jl=7;var Ql=300,Qi=301,Fs=302,Ea=303,Aa=304,Ko=1e3,qn=1001,jo=1002,Be=1003,ff=1004;var zr=1005;var cn=1006,Ta=1007;var pi=1008;var pn=1009,th=1010,eh=1011,Bs=1012,Ca=1013,kn=1014,Rn=1015,Gn=1016,Ra=1017,Pa=1018,ts=1020,nh=35902,ih=35899,sh=1021,rh=1022,Vn=1023,hi=1026,mi=1027,Ia=1028,La=1029,Oi=1030,Da=1031;var Na=1033,kr=33776,Gr=33777,Vr=33778,Hr=33779,Oa=35840,Ua=35841,Fa=35842,Ba=35843,za=36196,ka=37492,Ga=37496,Va=37488,Ha=37489,Wr=37490,Wa=37491,Xa=37808,qa=37809,$a=37810,Ya=37811,Za=37812,Ja=37813,Ka=37814,ja=37815,Qa=37816,tc=37817,ec=37818,nc=37819,ic=37820,sc=37821,rc=36492,oc=36494,ac=36495,cc=36283,lc=36284,Xr=36285,hc=36286;var ur=2300,Qo=2301,Vo=2302,Il=2303,Ll=2400,Dl=2401,Nl=2402;var pf=3200;var uc=0,mf=1,gi="",on="srgb",dr="srgb-linear",fr="linear",le="srgb";var Ho=7680;var gf=519,_f=512,xf=513,yf=514,oh=515,vf=516,Sf=517,ah=518,ch=519,lh=35044;var hh="300 es",An=2e3,As=2001;function X0(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function q0(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function pr(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function bf(){let n=pr("canvas");return n.style.display="block",n}var od={},Ts=null;function mr(...n){let t="THREE."+n.shift();Ts?Ts("log",t,...n):console.log(t,...n)}function Mf(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ot(...n){n=Mf(n);let t="THREE."+n.shift();if(Ts)Ts("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function Bt(...n){n=Mf(n);let t="THREE."+n.shift();if(Ts)Ts("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function cr(...n){let t=n.join(" ");t in od||(od[t]=!0,Ot(...n))}function wf(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Ef={[Wo]:Wo,[qo]:Zo,[$o]:$o,[Es]:Yo,[Xo]:Xo,[Zo]:qo,[Jo]:Jo,[Yo]:Es},Fn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Je=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],ad=1234567,lr=Math.PI/180,Cs=180/Math.PI;function Ui(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Je[n&255]+Je[n>>8&255]+Je[n>>16&255]+Je[n>>24&255]+"-"+Je[t&255]+Je[t>>8&255]+"-"+Je[t>>16&15|64]+Je[t>>24&255]+"-"+Je[e&63|128]+Je[e>>8&255]+"-"+Je[e>>16&255]+Je[e>>24&255]+Je[i&255]+Je[i>>8&255]+Je[i>>16&255]+Je[i>>24&255]).toLowerCase()}function Wt(n,t,e){return Math.max(t,Math.min(e,n))}function uh(n,t){return(n%t+t)%t}function $0(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function Y0(n,t,e){return n!==t?(e-n)/(t-n):0}function hr(n,t,e){return(1-e)*n+e*t}function Z0(n,t,e,i){return hr(n,t,1-Math.exp(-e*i))}function J0(n,t=1){return t-Math.abs(uh(n,t*2)-t)}function K0(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function j0(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Q0(n,t){return n+Math.floor(Math.random()*(t-n+1))}function t_(n,t){return n+Math.random()*(t-n)}function e_(n){return n*(.5-Math.random())}function n_(n){n!==void 0&&(ad=n);let t=ad+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function i_(n){return n*lr}function s_(n){return n*Cs}function r_(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function o_(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function dh(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function a_(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+i)/2),h=o((t+i)/2),d=r((t-i)/2),u=o((t-i)/2),p=r((i-t)/2),f=o((i-t)/2);switch(s){case"XYX":n.set(a*h,c*d,c*u,a*l);break;case"YZY":n.set(c*u,a*h,c*d,a*l);break;case"ZXZ":n.set(c*d,c*u,a*h,a*l);break;case"XZX":n.set(a*h,c*f,c*p,a*l);break;case"YXY":n.set(c*p,a*h,c*f,a*l);break;case"ZYZ":n.set(c*f,c*p,a*h,a*l);break;default:Ot("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function dc(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function fh(n,t){if(t.constructor===Float32Array)return n;let e=dc(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function ph(n,t){if(t.constructor===Float32Array)return n;let e=dc(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var qr={DEG2RAD:lr,RAD2DEG:Cs,generateUUID:Ui,clamp:Wt,euclideanModulo:uh,mapLinear:$0,inverseLerp:Y0,lerp:hr,damp:Z0,pingpong:J0,smoothstep:K0,smootherstep:j0,randInt:Q0,randFloat:t_,randFloatSpread:e_,seededRandom:n_,degToRad:i_,radToDeg:s_,isPowerOfTwo:r_,ceilPowerOfTwo:o_,floorPowerOfTwo:dh,setQuaternionFromProperEuler:a_,normalize:ph,denormalize:fh},yh=class yh{constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Wt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Wt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};yh.prototype.isVector2=!0;var Ut=yh,we=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let c=i[s+0],l=i[s+1],h=i[s+2],d=i[s+3],u=r[o+0],p=r[o+1],f=r[o+2],_=r[o+3];if(d!==_||c!==u||l!==p||h!==f){let g=c*u+l*p+h*f+d*_;g<0&&(u=-u,p=-p,f=-f,_=-_,g=-g);let m=1-a;if(g<.9995){let y=Math.acos(g),E=Math.sin(y);m=Math.sin(m*y)/E,a=Math.sin(a*y)/E,c=c*m+u*a,l=l*m+p*a,h=h*m+f*a,d=d*m+_*a}else{c=c*m+u*a,l=l*m+p*a,h=h*m+f*a,d=d*m+_*a;let y=1/Math.sqrt(c*c+l*l+h*h+d*d);c*=y,l*=y,h*=y,d*=y}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],c=i[s+1],l=i[s+2],h=i[s+3],d=r[o],u=r[o+1],p=r[o+2],f=r[o+3];return t[e]=a*f+h*d+c*p-l*u,t[e+1]=c*f+h*u+l*d-a*p,t[e+2]=l*f+h*p+a*u-c*d,t[e+3]=h*f-a*d-c*u-l*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(i/2),h=a(s/2),d=a(r/2),u=c(i/2),p=c(s/2),f=c(r/2);switch(o){case"XYZ":this._x=u*h*d+l*p*f,this._y=l*p*d-u*h*f,this._z=l*h*f+u*p*d,this._w=l*h*d-u*p*f;break;case"YXZ":this._x=u*h*d+l*p*f,this._y=l*p*d-u*h*f,this._z=l*h*f-u*p*d,this._w=l*h*d+u*p*f;break;case"ZXY":this._x=u*h*d-l*p*f,this._y=l*p*d+u*h*f,this._z=l*h*f+u*p*d,this._w=l*h*d-u*p*f;break;case"ZYX":this._x=u*h*d-l*p*f,this._y=l*p*d+u*h*f,this._z=l*h*f-u*p*d,this._w=l*h*d+u*p*f;break;case"YZX":this._x=u*h*d+l*p*f,this._y=l*p*d+u*h*f,this._z=l*h*f-u*p*d,this._w=l*h*d-u*p*f;break;case"XZY":this._x=u*h*d-l*p*f,this._y=l*p*d-u*h*f,this._z=l*h*f+u*p*d,this._w=l*h*d+u*p*f;break;default:Ot("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],h=e[6],d=e[10],u=i+a+d;if(u>0){let p=.5/Math.sqrt(u+1);this._w=.25/p,this._x=(h-c)*p,this._y=(r-l)*p,this._z=(o-s)*p}else if(i>a&&i>d){let p=2*Math.sqrt(1+i-a-d);this._w=(h-c)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+l)/p}else if(a>d){let p=2*Math.sqrt(1+a-i-d);this._w=(r-l)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(c+h)/p}else{let p=2*Math.sqrt(1+d-i-a);this._w=(o-s)/p,this._x=(r+l)/p,this._y=(c+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Wt(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,h=e._w;return this._x=i*h+o*a+s*l-r*c,this._y=s*h+o*c+r*a-i*l,this._z=r*h+o*l+i*c-s*a,this._w=o*h-i*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},vh=class vh{constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(cd.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(cd.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*i),h=2*(a*e-r*s),d=2*(r*i-o*e);return this.x=e+c*l+o*d-a*h,this.y=i+c*h+a*l-r*d,this.z=s+c*d+r*h-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Wt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=s*c-r*a,this.y=r*o-i*c,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return ll.copy(this).projectOnVector(t),this.sub(ll)}reflect(t){return this.sub(ll.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Wt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};vh.prototype.isVector3=!0;var C=vh,ll=new C,cd=new we,Sh=class Sh{constructor(t,e,i,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l)}set(t,e,i,s,r,o,a,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=c,h[6]=i,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],h=i[4],d=i[7],u=i[2],p=i[5],f=i[8],_=s[0],g=s[3],m=s[6],y=s[1],E=s[4],b=s[7],T=s[2],w=s[5],x=s[8];return r[0]=o*_+a*y+c*T,r[3]=o*g+a*E+c*w,r[6]=o*m+a*b+c*x,r[1]=l*_+h*y+d*T,r[4]=l*g+h*E+d*w,r[7]=l*m+h*b+d*x,r[2]=u*_+p*y+f*T,r[5]=u*g+p*E+f*w,r[8]=u*m+p*b+f*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8];return e*o*h-e*a*l-i*r*h+i*a*c+s*r*l-s*o*c}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],d=h*o-a*l,u=a*c-h*r,p=l*r-o*c,f=e*d+i*u+s*p;if(f===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/f;return t[0]=d*_,t[1]=(s*l-h*i)*_,t[2]=(a*i-s*o)*_,t[3]=u*_,t[4]=(h*e-s*c)*_,t[5]=(s*r-a*e)*_,t[6]=p*_,t[7]=(i*c-l*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(i*c,i*l,-i*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return cr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(hl.makeScale(t,e)),this}rotate(t){return cr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(hl.makeRotation(-t)),this}translate(t,e){return cr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(hl.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}};Sh.prototype.isMatrix3=!0;var zt=Sh,hl=new zt,ld=new zt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),hd=new zt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function c_(){let n={enabled:!0,workingColorSpace:dr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===le&&(s.r=li(s.r),s.g=li(s.g),s.b=li(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===le&&(s.r=ws(s.r),s.g=ws(s.g),s.b=ws(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===gi?fr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[dr]:{primaries:t,whitePoint:i,transfer:fr,toXYZ:ld,fromXYZ:hd,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:on},outputColorSpaceConfig:{drawingBufferColorSpace:on}},[on]:{primaries:t,whitePoint:i,transfer:le,toXYZ:ld,fromXYZ:hd,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:on}}}),n}var te=c_();function li(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ws(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var cs,ta=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{cs===void 0&&(cs=pr("canvas")),cs.width=t.width,cs.height=t.height;let s=cs.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=cs}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=pr("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=li(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(li(e[i]/255)*255):e[i]=li(e[i]);return{data:e,width:t.width,height:t.height}}else return Ot("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},l_=0,Rs=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:l_++}),this.uuid=Ui(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ul(s[o].image)):r.push(ul(s[o]))}else r=ul(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function ul(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?ta.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ot("Texture: Unable to serialize Texture."),{})}var h_=0,dl=new C,ln=class n extends Fn{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=qn,s=qn,r=cn,o=pi,a=Vn,c=pn,l=n.DEFAULT_ANISOTROPY,h=gi){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:h_++}),this.uuid=Ui(),this.name="",this.source=new Rs(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Ut(0,0),this.repeat=new Ut(1,1),this.center=new Ut(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new zt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(dl).x}get height(){return this.source.getSize(dl).y}get depth(){return this.source.getSize(dl).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Ot(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Ot(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Ql)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ko:t.x=t.x-Math.floor(t.x);break;case qn:t.x=t.x<0?0:1;break;case jo:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ko:t.y=t.y-Math.floor(t.y);break;case qn:t.y=t.y<0?0:1;break;case jo:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ln.DEFAULT_IMAGE=null;ln.DEFAULT_MAPPING=Ql;ln.DEFAULT_ANISOTROPY=1;var bh=class bh{constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,c=t.elements,l=c[0],h=c[4],d=c[8],u=c[1],p=c[5],f=c[9],_=c[2],g=c[6],m=c[10];if(Math.abs(h-u)<.01&&Math.abs(d-_)<.01&&Math.abs(f-g)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+_)<.1&&Math.abs(f+g)<.1&&Math.abs(l+p+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let E=(l+1)/2,b=(p+1)/2,T=(m+1)/2,w=(h+u)/4,x=(d+_)/4,M=(f+g)/4;return E>b&&E>T?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=w/i,r=x/i):b>T?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=w/s,r=M/s):T<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),i=x/r,s=M/r),this.set(i,s,r,e),this}let y=Math.sqrt((g-f)*(g-f)+(d-_)*(d-_)+(u-h)*(u-h));return Math.abs(y)<.001&&(y=1),this.x=(g-f)/y,this.y=(d-_)/y,this.z=(u-h)/y,this.w=Math.acos((l+p+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this.w=Wt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this.w=Wt(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Wt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};bh.prototype.isVector4=!0;var ue=bh,ea=class extends Fn{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:cn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new ue(0,0,t,e),this.scissorTest=!1,this.viewport=new ue(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ln({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:cn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Rs(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},xn=class extends ea{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},gr=class extends ln{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Be,this.minFilter=Be,this.wrapR=qn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var na=class extends ln{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Be,this.minFilter=Be,this.wrapR=qn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Ma=class Ma{constructor(t,e,i,s,r,o,a,c,l,h,d,u,p,f,_,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l,h,d,u,p,f,_,g)}set(t,e,i,s,r,o,a,c,l,h,d,u,p,f,_,g){let m=this.elements;return m[0]=t,m[4]=e,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=c,m[2]=l,m[6]=h,m[10]=d,m[14]=u,m[3]=p,m[7]=f,m[11]=_,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Ma().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/ls.setFromMatrixColumn(t,0).length(),r=1/ls.setFromMatrixColumn(t,1).length(),o=1/ls.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let u=o*h,p=o*d,f=a*h,_=a*d;e[0]=c*h,e[4]=-c*d,e[8]=l,e[1]=p+f*l,e[5]=u-_*l,e[9]=-a*c,e[2]=_-u*l,e[6]=f+p*l,e[10]=o*c}else if(t.order==="YXZ"){let u=c*h,p=c*d,f=l*h,_=l*d;e[0]=u+_*a,e[4]=f*a-p,e[8]=o*l,e[1]=o*d,e[5]=o*h,e[9]=-a,e[2]=p*a-f,e[6]=_+u*a,e[10]=o*c}else if(t.order==="ZXY"){let u=c*h,p=c*d,f=l*h,_=l*d;e[0]=u-_*a,e[4]=-o*d,e[8]=f+p*a,e[1]=p+f*a,e[5]=o*h,e[9]=_-u*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let u=o*h,p=o*d,f=a*h,_=a*d;e[0]=c*h,e[4]=f*l-p,e[8]=u*l+_,e[1]=c*d,e[5]=_*l+u,e[9]=p*l-f,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let u=o*c,p=o*l,f=a*c,_=a*l;e[0]=c*h,e[4]=_-u*d,e[8]=f*d+p,e[1]=d,e[5]=o*h,e[9]=-a*h,e[2]=-l*h,e[6]=p*d+f,e[10]=u-_*d}else if(t.order==="XZY"){let u=o*c,p=o*l,f=a*c,_=a*l;e[0]=c*h,e[4]=-d,e[8]=l*h,e[1]=u*d+_,e[5]=o*h,e[9]=p*d-f,e[2]=f*d-p,e[6]=a*h,e[10]=_*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(u_,t,d_)}lookAt(t,e,i){let s=this.elements;return gn.subVectors(t,e),gn.lengthSq()===0&&(gn.z=1),gn.normalize(),vi.crossVectors(i,gn),vi.lengthSq()===0&&(Math.abs(i.z)===1?gn.x+=1e-4:gn.z+=1e-4,gn.normalize(),vi.crossVectors(i,gn)),vi.normalize(),go.crossVectors(gn,vi),s[0]=vi.x,s[4]=go.x,s[8]=gn.x,s[1]=vi.y,s[5]=go.y,s[9]=gn.y,s[2]=vi.z,s[6]=go.z,s[10]=gn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],h=i[1],d=i[5],u=i[9],p=i[13],f=i[2],_=i[6],g=i[10],m=i[14],y=i[3],E=i[7],b=i[11],T=i[15],w=s[0],x=s[4],M=s[8],D=s[12],P=s[1],O=s[5],B=s[9],q=s[13],I=s[2],V=s[6],Y=s[10],W=s[14],st=s[3],F=s[7],X=s[11],j=s[15];return r[0]=o*w+a*P+c*I+l*st,r[4]=o*x+a*O+c*V+l*F,r[8]=o*M+a*B+c*Y+l*X,r[12]=o*D+a*q+c*W+l*j,r[1]=h*w+d*P+u*I+p*st,r[5]=h*x+d*O+u*V+p*F,r[9]=h*M+d*B+u*Y+p*X,r[13]=h*D+d*q+u*W+p*j,r[2]=f*w+_*P+g*I+m*st,r[6]=f*x+_*O+g*V+m*F,r[10]=f*M+_*B+g*Y+m*X,r[14]=f*D+_*q+g*W+m*j,r[3]=y*w+E*P+b*I+T*st,r[7]=y*x+E*O+b*V+T*F,r[11]=y*M+E*B+b*Y+T*X,r[15]=y*D+E*q+b*W+T*j,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],h=t[2],d=t[6],u=t[10],p=t[14],f=t[3],_=t[7],g=t[11],m=t[15],y=c*p-l*u,E=a*p-l*d,b=a*u-c*d,T=o*p-l*h,w=o*u-c*h,x=o*d-a*h;return e*(_*y-g*E+m*b)-i*(f*y-g*T+m*w)+s*(f*E-_*T+m*x)-r*(f*b-_*w+g*x)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],h=t[10];return e*(o*h-a*l)-i*(r*h-a*c)+s*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],d=t[9],u=t[10],p=t[11],f=t[12],_=t[13],g=t[14],m=t[15],y=e*a-i*o,E=e*c-s*o,b=e*l-r*o,T=i*c-s*a,w=i*l-r*a,x=s*l-r*c,M=h*_-d*f,D=h*g-u*f,P=h*m-p*f,O=d*g-u*_,B=d*m-p*_,q=u*m-p*g,I=y*q-E*B+b*O+T*P-w*D+x*M;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/I;return t[0]=(a*q-c*B+l*O)*V,t[1]=(s*B-i*q-r*O)*V,t[2]=(_*x-g*w+m*T)*V,t[3]=(u*w-d*x-p*T)*V,t[4]=(c*P-o*q-l*D)*V,t[5]=(e*q-s*P+r*D)*V,t[6]=(g*b-f*x-m*E)*V,t[7]=(h*x-u*b+p*E)*V,t[8]=(o*B-a*P+l*M)*V,t[9]=(i*P-e*B-r*M)*V,t[10]=(f*w-_*b+m*y)*V,t[11]=(d*b-h*w-p*y)*V,t[12]=(a*D-o*O-c*M)*V,t[13]=(e*O-i*D+s*M)*V,t[14]=(_*E-f*T-g*y)*V,t[15]=(h*T-d*E+u*y)*V,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,c=t.z,l=r*o,h=r*a;return this.set(l*o+i,l*a-s*c,l*c+s*a,0,l*a+s*c,h*a+i,h*c-s*o,0,l*c-s*a,h*c+s*o,r*c*c+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,h=o+o,d=a+a,u=r*l,p=r*h,f=r*d,_=o*h,g=o*d,m=a*d,y=c*l,E=c*h,b=c*d,T=i.x,w=i.y,x=i.z;return s[0]=(1-(_+m))*T,s[1]=(p+b)*T,s[2]=(f-E)*T,s[3]=0,s[4]=(p-b)*w,s[5]=(1-(u+m))*w,s[6]=(g+y)*w,s[7]=0,s[8]=(f+E)*x,s[9]=(g-y)*x,s[10]=(1-(u+_))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=ls.set(s[0],s[1],s[2]).length(),a=ls.set(s[4],s[5],s[6]).length(),c=ls.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Nn.copy(this);let l=1/o,h=1/a,d=1/c;return Nn.elements[0]*=l,Nn.elements[1]*=l,Nn.elements[2]*=l,Nn.elements[4]*=h,Nn.elements[5]*=h,Nn.elements[6]*=h,Nn.elements[8]*=d,Nn.elements[9]*=d,Nn.elements[10]*=d,e.setFromRotationMatrix(Nn),i.x=o,i.y=a,i.z=c,this}makePerspective(t,e,i,s,r,o,a=An,c=!1){let l=this.elements,h=2*r/(e-t),d=2*r/(i-s),u=(e+t)/(e-t),p=(i+s)/(i-s),f,_;if(c)f=r/(o-r),_=o*r/(o-r);else if(a===An)f=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===As)f=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=d,l[9]=p,l[13]=0,l[2]=0,l[6]=0,l[10]=f,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=An,c=!1){let l=this.elements,h=2/(e-t),d=2/(i-s),u=-(e+t)/(e-t),p=-(i+s)/(i-s),f,_;if(c)f=1/(o-r),_=o/(o-r);else if(a===An)f=-2/(o-r),_=-(o+r)/(o-r);else if(a===As)f=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=u,l[1]=0,l[5]=d,l[9]=0,l[13]=p,l[2]=0,l[6]=0,l[10]=f,l[14]=_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}};Ma.prototype.isMatrix4=!0;var Jt=Ma,ls=new C,Nn=new Jt,u_=new C(0,0,0),d_=new C(1,1,1),vi=new C,go=new C,gn=new C,ud=new Jt,dd=new we,Bn=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],h=s[9],d=s[2],u=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(Wt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Wt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(Wt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,p),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Wt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,p),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(Wt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-Wt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,p),this._y=0);break;default:Ot("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return ud.makeRotationFromQuaternion(t),this.setFromRotationMatrix(ud,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return dd.setFromEuler(this),this.setFromQuaternion(dd,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Bn.DEFAULT_ORDER="XYZ";var Ps=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},f_=0,fd=new C,hs=new we,si=new Jt,_o=new C,er=new C,p_=new C,m_=new we,pd=new C(1,0,0),md=new C(0,1,0),gd=new C(0,0,1),_d={type:"added"},g_={type:"removed"},us={type:"childadded",child:null},fl={type:"childremoved",child:null},Ie=class n extends Fn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:f_++}),this.uuid=Ui(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new C,e=new Bn,i=new we,s=new C(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Jt},normalMatrix:{value:new zt}}),this.matrix=new Jt,this.matrixWorld=new Jt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ps,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return hs.setFromAxisAngle(t,e),this.quaternion.multiply(hs),this}rotateOnWorldAxis(t,e){return hs.setFromAxisAngle(t,e),this.quaternion.premultiply(hs),this}rotateX(t){return this.rotateOnAxis(pd,t)}rotateY(t){return this.rotateOnAxis(md,t)}rotateZ(t){return this.rotateOnAxis(gd,t)}translateOnAxis(t,e){return fd.copy(t).applyQuaternion(this.quaternion),this.position.add(fd.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(pd,t)}translateY(t){return this.translateOnAxis(md,t)}translateZ(t){return this.translateOnAxis(gd,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(si.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?_o.copy(t):_o.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),er.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?si.lookAt(er,_o,this.up):si.lookAt(_o,er,this.up),this.quaternion.setFromRotationMatrix(si),s&&(si.extractRotation(s.matrixWorld),hs.setFromRotationMatrix(si),this.quaternion.premultiply(hs.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Bt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(_d),us.child=t,this.dispatchEvent(us),us.child=null):Bt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(g_),fl.child=t,this.dispatchEvent(fl),fl.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),si.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),si.multiply(t.parent.matrixWorld)),t.applyMatrix4(si),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(_d),us.child=t,this.dispatchEvent(us),us.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(er,t,p_),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(er,m_,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let d=c[l];r(t.shapes,d)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),h=o(t.images),d=o(t.shapes),u=o(t.skeletons),p=o(t.animations),f=o(t.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),h.length>0&&(i.images=h),d.length>0&&(i.shapes=d),u.length>0&&(i.skeletons=u),p.length>0&&(i.animations=p),f.length>0&&(i.nodes=f)}return i.object=s,i;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ie.DEFAULT_UP=new C(0,1,0);Ie.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ie.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ee=class extends Ie{constructor(){super(),this.isGroup=!0,this.type="Group"}},__={type:"move"},Is=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ee,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ee,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new C,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new C),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ee,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new C,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new C,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let _ of t.hand.values()){let g=e.getJointPose(_,i),m=this._getHandJoint(l,_);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let h=l.joints["index-finger-tip"],d=l.joints["thumb-tip"],u=h.position.distanceTo(d.position),p=.02,f=.005;l.inputState.pinching&&u>p+f?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&u<=p-f&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(__)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new ee;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Af={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Si={h:0,s:0,l:0},xo={h:0,s:0,l:0};function pl(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var kt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=on){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,te.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=te.workingColorSpace){return this.r=t,this.g=e,this.b=i,te.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=te.workingColorSpace){if(t=uh(t,1),e=Wt(e,0,1),i=Wt(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=pl(o,r,t+1/3),this.g=pl(o,r,t),this.b=pl(o,r,t-1/3)}return te.colorSpaceToWorking(this,s),this}setStyle(t,e=on){function i(r){r!==void 0&&parseFloat(r)<1&&Ot("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Ot("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Ot("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=on){let i=Af[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Ot("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=li(t.r),this.g=li(t.g),this.b=li(t.b),this}copyLinearToSRGB(t){return this.r=ws(t.r),this.g=ws(t.g),this.b=ws(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=on){return te.workingToColorSpace(Ke.copy(this),t),Math.round(Wt(Ke.r*255,0,255))*65536+Math.round(Wt(Ke.g*255,0,255))*256+Math.round(Wt(Ke.b*255,0,255))}getHexString(t=on){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=te.workingColorSpace){te.workingToColorSpace(Ke.copy(this),e);let i=Ke.r,s=Ke.g,r=Ke.b,o=Math.max(i,s,r),a=Math.min(i,s,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let d=o-a;switch(l=h<=.5?d/(o+a):d/(2-o-a),o){case i:c=(s-r)/d+(s<r?6:0);break;case s:c=(r-i)/d+2;break;case r:c=(i-s)/d+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=te.workingColorSpace){return te.workingToColorSpace(Ke.copy(this),e),t.r=Ke.r,t.g=Ke.g,t.b=Ke.b,t}getStyle(t=on){te.workingToColorSpace(Ke.copy(this),t);let e=Ke.r,i=Ke.g,s=Ke.b;return t!==on?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Si),this.setHSL(Si.h+t,Si.s+e,Si.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Si),t.getHSL(xo);let i=hr(Si.h,xo.h,e),s=hr(Si.s,xo.s,e),r=hr(Si.l,xo.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ke=new kt;kt.NAMES=Af;var _r=class extends Ie{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Bn,this.environmentIntensity=1,this.environmentRotation=new Bn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},On=new C,ri=new C,ml=new C,oi=new C,ds=new C,fs=new C,xd=new C,gl=new C,_l=new C,xl=new C,yl=new ue,vl=new ue,Sl=new ue,Ei=class n{constructor(t=new C,e=new C,i=new C){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),On.subVectors(t,e),s.cross(On);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){On.subVectors(s,e),ri.subVectors(i,e),ml.subVectors(t,e);let o=On.dot(On),a=On.dot(ri),c=On.dot(ml),l=ri.dot(ri),h=ri.dot(ml),d=o*l-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,p=(l*c-a*h)*u,f=(o*h-a*c)*u;return r.set(1-p-f,f,p)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,oi)===null?!1:oi.x>=0&&oi.y>=0&&oi.x+oi.y<=1}static getInterpolation(t,e,i,s,r,o,a,c){return this.getBarycoord(t,e,i,s,oi)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,oi.x),c.addScaledVector(o,oi.y),c.addScaledVector(a,oi.z),c)}static getInterpolatedAttribute(t,e,i,s,r,o){return yl.setScalar(0),vl.setScalar(0),Sl.setScalar(0),yl.fromBufferAttribute(t,e),vl.fromBufferAttribute(t,i),Sl.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(yl,r.x),o.addScaledVector(vl,r.y),o.addScaledVector(Sl,r.z),o}static isFrontFacing(t,e,i,s){return On.subVectors(i,e),ri.subVectors(t,e),On.cross(ri).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return On.subVectors(this.c,this.b),ri.subVectors(this.a,this.b),On.cross(ri).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;ds.subVectors(s,i),fs.subVectors(r,i),gl.subVectors(t,i);let c=ds.dot(gl),l=fs.dot(gl);if(c<=0&&l<=0)return e.copy(i);_l.subVectors(t,s);let h=ds.dot(_l),d=fs.dot(_l);if(h>=0&&d<=h)return e.copy(s);let u=c*d-h*l;if(u<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),e.copy(i).addScaledVector(ds,o);xl.subVectors(t,r);let p=ds.dot(xl),f=fs.dot(xl);if(f>=0&&p<=f)return e.copy(r);let _=p*l-c*f;if(_<=0&&l>=0&&f<=0)return a=l/(l-f),e.copy(i).addScaledVector(fs,a);let g=h*f-p*d;if(g<=0&&d-h>=0&&p-f>=0)return xd.subVectors(r,s),a=(d-h)/(d-h+(p-f)),e.copy(s).addScaledVector(xd,a);let m=1/(g+_+u);return o=_*m,a=u*m,e.copy(i).addScaledVector(ds,o).addScaledVector(fs,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},ve=class{constructor(t=new C(1/0,1/0,1/0),e=new C(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Un.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Un.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Un.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Un):Un.fromBufferAttribute(r,o),Un.applyMatrix4(t.matrixWorld),this.expandByPoint(Un);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),yo.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),yo.copy(i.boundingBox)),yo.applyMatrix4(t.matrixWorld),this.union(yo)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Un),Un.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(nr),vo.subVectors(this.max,nr),ps.subVectors(t.a,nr),ms.subVectors(t.b,nr),gs.subVectors(t.c,nr),bi.subVectors(ms,ps),Mi.subVectors(gs,ms),Hi.subVectors(ps,gs);let e=[0,-bi.z,bi.y,0,-Mi.z,Mi.y,0,-Hi.z,Hi.y,bi.z,0,-bi.x,Mi.z,0,-Mi.x,Hi.z,0,-Hi.x,-bi.y,bi.x,0,-Mi.y,Mi.x,0,-Hi.y,Hi.x,0];return!bl(e,ps,ms,gs,vo)||(e=[1,0,0,0,1,0,0,0,1],!bl(e,ps,ms,gs,vo))?!1:(So.crossVectors(bi,Mi),e=[So.x,So.y,So.z],bl(e,ps,ms,gs,vo))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Un).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Un).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ai[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ai[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ai[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ai[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ai[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ai[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ai[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ai[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ai),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ai=[new C,new C,new C,new C,new C,new C,new C,new C],Un=new C,yo=new ve,ps=new C,ms=new C,gs=new C,bi=new C,Mi=new C,Hi=new C,nr=new C,vo=new C,So=new C,Wi=new C;function bl(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Wi.fromArray(n,r);let a=s.x*Math.abs(Wi.x)+s.y*Math.abs(Wi.y)+s.z*Math.abs(Wi.z),c=t.dot(Wi),l=e.dot(Wi),h=i.dot(Wi);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var Ce=new C,bo=new Ut,x_=0,Tn=class extends Fn{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:x_++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=lh,this.updateRanges=[],this.gpuType=Rn,this.version=0,this._normalizationScale=t!==void 0?dc(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)bo.fromBufferAttribute(this,e),bo.applyMatrix3(t),this.setXY(e,bo.x,bo.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Ce.fromBufferAttribute(this,e),Ce.applyMatrix3(t),this.setXYZ(e,Ce.x,Ce.y,Ce.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Ce.fromBufferAttribute(this,e),Ce.applyMatrix4(t),this.setXYZ(e,Ce.x,Ce.y,Ce.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Ce.fromBufferAttribute(this,e),Ce.applyNormalMatrix(t),this.setXYZ(e,Ce.x,Ce.y,Ce.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Ce.fromBufferAttribute(this,e),Ce.transformDirection(t),this.setXYZ(e,Ce.x,Ce.y,Ce.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):fh(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):ph(t,this.array)}};var xr=class extends Tn{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var yr=class extends Tn{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var he=class extends Tn{constructor(t,e,i){super(new Float32Array(t),e,i)}},y_=new ve,ir=new C,Ml=new C,fn=class{constructor(t=new C,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):y_.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ir.subVectors(t,this.center);let e=ir.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(ir,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Ml.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ir.copy(t.center).add(Ml)),this.expandByPoint(ir.copy(t.center).sub(Ml))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},v_=0,En=new Jt,wl=new Ie,_s=new C,_n=new ve,sr=new ve,Fe=new C,Ae=class n extends Fn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:v_++}),this.uuid=Ui(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(X0(t)?yr:xr)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new zt().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return En.makeRotationFromQuaternion(t),this.applyMatrix4(En),this}rotateX(t){return En.makeRotationX(t),this.applyMatrix4(En),this}rotateY(t){return En.makeRotationY(t),this.applyMatrix4(En),this}rotateZ(t){return En.makeRotationZ(t),this.applyMatrix4(En),this}translate(t,e,i){return En.makeTranslation(t,e,i),this.applyMatrix4(En),this}scale(t,e,i){return En.makeScale(t,e,i),this.applyMatrix4(En),this}lookAt(t){return wl.lookAt(t),wl.updateMatrix(),this.applyMatrix4(wl.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(_s).negate(),this.translate(_s.x,_s.y,_s.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new he(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Ot("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ve);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Bt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new C(-1/0,-1/0,-1/0),new C(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];_n.setFromBufferAttribute(r),this.morphTargetsRelative?(Fe.addVectors(this.boundingBox.min,_n.min),this.boundingBox.expandByPoint(Fe),Fe.addVectors(this.boundingBox.max,_n.max),this.boundingBox.expandByPoint(Fe)):(this.boundingBox.expandByPoint(_n.min),this.boundingBox.expandByPoint(_n.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Bt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new fn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Bt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new C,1/0);return}if(t){let i=this.boundingSphere.center;if(_n.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];sr.setFromBufferAttribute(a),this.morphTargetsRelative?(Fe.addVectors(_n.min,sr.min),_n.expandByPoint(Fe),Fe.addVectors(_n.max,sr.max),_n.expandByPoint(Fe)):(_n.expandByPoint(sr.min),_n.expandByPoint(sr.max))}_n.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Fe.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Fe));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)Fe.fromBufferAttribute(a,l),c&&(_s.fromBufferAttribute(t,l),Fe.add(_s)),s=Math.max(s,i.distanceToSquared(Fe))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Bt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Bt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Tn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let D=0;D<i.count;D++)a[D]=new C,c[D]=new C;let h=new C,d=new C,u=new C,p=new Ut,f=new Ut,_=new Ut,g=new C,m=new C;function y(D,P,O){l[D]=l[P]=l[O]=1,h.fromBufferAttribute(i,D),d.fromBufferAttribute(i,P),u.fromBufferAttribute(i,O),p.fromBufferAttribute(r,D),f.fromBufferAttribute(r,P),_.fromBufferAttribute(r,O),d.sub(h),u.sub(h),f.sub(p),_.sub(p);let B=1/(f.x*_.y-_.x*f.y);isFinite(B)&&(g.copy(d).multiplyScalar(_.y).addScaledVector(u,-f.y).multiplyScalar(B),m.copy(u).multiplyScalar(f.x).addScaledVector(d,-_.x).multiplyScalar(B),a[D].add(g),a[P].add(g),a[O].add(g),c[D].add(m),c[P].add(m),c[O].add(m))}let E=this.groups;E.length===0&&(E=[{start:0,count:t.count}]);for(let D=0,P=E.length;D<P;++D){let O=E[D],B=O.start,q=O.count;for(let I=B,V=B+q;I<V;I+=3)y(t.getX(I+0),t.getX(I+1),t.getX(I+2))}let b=new C,T=new C,w=new C,x=new C;function M(D){w.fromBufferAttribute(s,D),x.copy(w);let P=a[D];b.copy(P),b.sub(w.multiplyScalar(w.dot(P))).normalize(),T.crossVectors(x,P);let B=T.dot(c[D])<0?-1:1;o.setXYZW(D,b.x,b.y,b.z,B)}for(let D=0,P=i.count;D<P;++D)l[D]&&M(D);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Tn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let u=0,p=i.count;u<p;u++)i.setXYZ(u,0,0,0);let s=new C,r=new C,o=new C,a=new C,c=new C,l=new C,h=new C,d=new C;if(t)for(let u=0,p=t.count;u<p;u+=3){let f=t.getX(u+0),_=t.getX(u+1),g=t.getX(u+2);s.fromBufferAttribute(e,f),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,g),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(i,f),c.fromBufferAttribute(i,_),l.fromBufferAttribute(i,g),a.add(h),c.add(h),l.add(h),i.setXYZ(f,a.x,a.y,a.z),i.setXYZ(_,c.x,c.y,c.z),i.setXYZ(g,l.x,l.y,l.z)}else for(let u=0,p=e.count;u<p;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),i.setXYZ(u+0,h.x,h.y,h.z),i.setXYZ(u+1,h.x,h.y,h.z),i.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Fe.fromBufferAttribute(t,e),Fe.normalize(),t.setXYZ(e,Fe.x,Fe.y,Fe.z)}toNonIndexed(){function t(a,c){let l=a.array,h=a.itemSize,d=a.normalized,u=new l.constructor(c.length*h),p=0,f=0;for(let _=0,g=c.length;_<g;_++){a.isInterleavedBufferAttribute?p=c[_]*a.data.stride+a.offset:p=c[_]*h;for(let m=0;m<h;m++)u[f++]=l[p++]}return new Tn(u,h,d)}if(this.index===null)return Ot("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,i);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,d=l.length;h<d;h++){let u=l[h],p=t(u,i);c.push(p)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let c in i){let l=i[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let d=0,u=l.length;d<u;d++){let p=l[d];h.push(p.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],d=r[l];for(let u=0,p=d.length;u<p;u++)h.push(d[u].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,h=o.length;l<h;l++){let d=o[l];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},ia=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=lh,this.updateRanges=[],this.version=0,this.uuid=Ui()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=yd(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=yd(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function yd(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Ui()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var rn=new C,zn=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?dc(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)rn.fromBufferAttribute(this,e),rn.applyMatrix4(t),this.setXYZ(e,rn.x,rn.y,rn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)rn.fromBufferAttribute(this,e),rn.applyNormalMatrix(t),this.setXYZ(e,rn.x,rn.y,rn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)rn.fromBufferAttribute(this,e),rn.transformDirection(t),this.setXYZ(e,rn.x,rn.y,rn.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){mr("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Tn(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){mr("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):fh(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):ph(t,this.data.array)}},El=new C,S_=new C,b_=new zt,He=class{constructor(t=new C(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=El.subVectors(i,e).cross(S_.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(El),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||b_.getNormalMatrix(t),s=this.coplanarPoint(El).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},M_=0,$n=class extends Fn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:M_++}),this.uuid=Ui(),this.name="",this.type="Material",this.blending=Us,this.side=Ni,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Wl,this.blendDst=Xl,this.blendEquation=ji,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new kt(0,0,0),this.blendAlpha=0,this.depthFunc=Es,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=gf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ho,this.stencilZFail=Ho,this.stencilZPass=Ho,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Ot(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Ot(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new kt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new He().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ut().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ut().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var ci=new C,Al=new C,Mo=new C,wo=new C,ui=class{constructor(t=new C,e=new C(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ci)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ci.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ci.copy(this.origin).addScaledVector(this.direction,e),ci.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Al.copy(t).add(e).multiplyScalar(.5),Mo.copy(e).sub(t).normalize(),wo.copy(this.origin).sub(Al);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Mo),a=wo.dot(this.direction),c=-wo.dot(Mo),l=wo.lengthSq(),h=Math.abs(1-o*o),d,u,p,f;if(h>0)if(d=o*c-a,u=o*a-c,f=r*h,d>=0)if(u>=-f)if(u<=f){let _=1/h;d*=_,u*=_,p=d*(d+o*u+2*a)+u*(o*d+u+2*c)+l}else u=r,d=Math.max(0,-(o*u+a)),p=-d*d+u*(u+2*c)+l;else u=-r,d=Math.max(0,-(o*u+a)),p=-d*d+u*(u+2*c)+l;else u<=-f?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-c),r),p=-d*d+u*(u+2*c)+l):u<=f?(d=0,u=Math.min(Math.max(-r,-c),r),p=u*(u+2*c)+l):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-c),r),p=-d*d+u*(u+2*c)+l);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),p=-d*d+u*(u+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Al).addScaledVector(Mo,u),p}intersectSphere(t,e){if(t.radius<0)return null;ci.subVectors(t.center,this.origin);let i=ci.dot(this.direction),s=ci.dot(ci)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return l>=0?(i=(t.min.x-u.x)*l,s=(t.max.x-u.x)*l):(i=(t.max.x-u.x)*l,s=(t.min.x-u.x)*l),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-u.z)*d,c=(t.max.z-u.z)*d):(a=(t.max.z-u.z)*d,c=(t.min.z-u.z)*d),i>c||a>s)||((a>i||i!==i)&&(i=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,ci)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,d=t.x-o.x,u=t.y-o.y,p=t.z-o.z,f=e.x-o.x,_=e.y-o.y,g=e.z-o.z,m=i.x-o.x,y=i.y-o.y,E=i.z-o.z,b=Math.abs(c),T=Math.abs(l),w=Math.abs(h),x,M,D,P,O,B,q,I,V,Y,W,st;if(b>=T&&b>=w?(D=c,B=d,V=f,st=m,c>=0?(x=l,M=h,P=u,O=p,q=_,I=g,Y=y,W=E):(x=h,M=l,P=p,O=u,q=g,I=_,Y=E,W=y)):T>=w?(D=l,B=u,V=_,st=y,l>=0?(x=h,M=c,P=p,O=d,q=g,I=f,Y=E,W=m):(x=c,M=h,P=d,O=p,q=f,I=g,Y=m,W=E)):(D=h,B=p,V=g,st=E,h>=0?(x=c,M=l,P=d,O=u,q=f,I=_,Y=m,W=y):(x=l,M=c,P=u,O=d,q=_,I=f,Y=y,W=m)),D===0)return null;let F=x/D,X=M/D,j=1/D,ot=P-F*B,$=O-X*B,R=q-F*V,z=I-X*V,it=Y-F*st,ht=W-X*st,rt=it*z-ht*R,Ct=ot*ht-$*it,re=R*$-z*ot;if(s){if(rt<0||Ct<0||re<0)return null}else if((rt<0||Ct<0||re<0)&&(rt>0||Ct>0||re>0))return null;let It=rt+Ct+re;if(It===0)return null;let Kt=j*(rt*B+Ct*V+re*st);return(It>0?Kt<0:Kt>0)?null:this.at(Kt/It,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},yn=class extends $n{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new kt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Bn,this.combine=wa,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},vd=new Jt,Xi=new ui,Eo=new fn,Sd=new C,Ao=new C,To=new C,Co=new C,Tl=new C,Ro=new C,bd=new C,Po=new C,ne=class extends Ie{constructor(t=new Ae,e=new yn){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Ro.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],d=r[c];h!==0&&(Tl.fromBufferAttribute(d,t),o?Ro.addScaledVector(Tl,h):Ro.addScaledVector(Tl.sub(e),h))}e.add(Ro)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Eo.copy(i.boundingSphere),Eo.applyMatrix4(r),Xi.copy(t.ray).recast(t.near),!(Eo.containsPoint(Xi.origin)===!1&&(Xi.intersectSphere(Eo,Sd)===null||Xi.origin.distanceToSquared(Sd)>(t.far-t.near)**2))&&(vd.copy(r).invert(),Xi.copy(t.ray).applyMatrix4(vd),!(i.boundingBox!==null&&Xi.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Xi)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let f=0,_=u.length;f<_;f++){let g=u[f],m=o[g.materialIndex],y=Math.max(g.start,p.start),E=Math.min(a.count,Math.min(g.start+g.count,p.start+p.count));for(let b=y,T=E;b<T;b+=3){let w=a.getX(b),x=a.getX(b+1),M=a.getX(b+2);s=Io(this,m,t,i,l,h,d,w,x,M),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let f=Math.max(0,p.start),_=Math.min(a.count,p.start+p.count);for(let g=f,m=_;g<m;g+=3){let y=a.getX(g),E=a.getX(g+1),b=a.getX(g+2);s=Io(this,o,t,i,l,h,d,y,E,b),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let f=0,_=u.length;f<_;f++){let g=u[f],m=o[g.materialIndex],y=Math.max(g.start,p.start),E=Math.min(c.count,Math.min(g.start+g.count,p.start+p.count));for(let b=y,T=E;b<T;b+=3){let w=b,x=b+1,M=b+2;s=Io(this,m,t,i,l,h,d,w,x,M),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let f=Math.max(0,p.start),_=Math.min(c.count,p.start+p.count);for(let g=f,m=_;g<m;g+=3){let y=g,E=g+1,b=g+2;s=Io(this,o,t,i,l,h,d,y,E,b),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function w_(n,t,e,i,s,r,o,a){let c;if(t.side===hn?c=i.intersectTriangle(o,r,s,!0,a):c=i.intersectTriangle(s,r,o,t.side===Ni,a),c===null)return null;Po.copy(a),Po.applyMatrix4(n.matrixWorld);let l=e.ray.origin.distanceTo(Po);return l<e.near||l>e.far?null:{distance:l,point:Po.clone(),object:n}}function Io(n,t,e,i,s,r,o,a,c,l){n.getVertexPosition(a,Ao),n.getVertexPosition(c,To),n.getVertexPosition(l,Co);let h=w_(n,t,e,i,Ao,To,Co,bd);if(h){let d=new C;Ei.getBarycoord(bd,Ao,To,Co,d),s&&(h.uv=Ei.getInterpolatedAttribute(s,a,c,l,d,new Ut)),r&&(h.uv1=Ei.getInterpolatedAttribute(r,a,c,l,d,new Ut)),o&&(h.normal=Ei.getInterpolatedAttribute(o,a,c,l,d,new C),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:c,c:l,normal:new C,materialIndex:0};Ei.getNormal(Ao,To,Co,u.normal),h.face=u,h.barycoord=d}return h}var vr=class extends ln{constructor(t=null,e=1,i=1,s,r,o,a,c,l=Be,h=Be,d,u){super(null,o,a,c,l,h,s,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Sr=class extends Tn{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},xs=new Jt,Md=new Jt,Lo=[],wd=new ve,E_=new Jt,rr=new ne,or=new fn,$i=class extends ne{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Sr(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,E_)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new ve),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,xs),wd.copy(t.boundingBox).applyMatrix4(xs),this.boundingBox.union(wd)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new fn),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,xs),or.copy(t.boundingSphere).applyMatrix4(xs),this.boundingSphere.union(or)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(rr.geometry=this.geometry,rr.material=this.material,rr.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),or.copy(this.boundingSphere),or.applyMatrix4(i),t.ray.intersectsSphere(or)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,xs),Md.multiplyMatrices(i,xs),rr.matrixWorld=Md,rr.raycast(t,Lo);for(let o=0,a=Lo.length;o<a;o++){let c=Lo[o];c.instanceId=r,c.object=this,e.push(c)}Lo.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Sr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new vr(new Float32Array(s*this.count),s,this.count,Ia,Rn));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<i.length;l++)o+=i[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=s*t;return r[c]=a,r.set(i,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},qi=new fn,A_=new Ut(.5,.5),Do=new C,Ai=class{constructor(t=new He,e=new He,i=new He,s=new He,r=new He,o=new He){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=An,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],h=r[4],d=r[5],u=r[6],p=r[7],f=r[8],_=r[9],g=r[10],m=r[11],y=r[12],E=r[13],b=r[14],T=r[15];if(s[0].setComponents(l-o,p-h,m-f,T-y).normalize(),s[1].setComponents(l+o,p+h,m+f,T+y).normalize(),s[2].setComponents(l+a,p+d,m+_,T+E).normalize(),s[3].setComponents(l-a,p-d,m-_,T-E).normalize(),i)s[4].setComponents(c,u,g,b).normalize(),s[5].setComponents(l-c,p-u,m-g,T-b).normalize();else if(s[4].setComponents(l-c,p-u,m-g,T-b).normalize(),e===An)s[5].setComponents(l+c,p+u,m+g,T+b).normalize();else if(e===As)s[5].setComponents(c,u,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),qi.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),qi.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(qi)}intersectsSprite(t){qi.center.set(0,0,0);let e=A_.distanceTo(t.center);return qi.radius=.7071067811865476+e,qi.applyMatrix4(t.matrixWorld),this.intersectsSphere(qi)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Do.x=s.normal.x>0?t.max.x:t.min.x,Do.y=s.normal.y>0?t.max.y:t.min.y,Do.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Do)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Ed=new Jt,sa=class n{constructor(){this.coordinateSystem=An,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Ed.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Ai),i[s].setFromProjectionMatrix(Ed,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Ai),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var je=class extends $n{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new kt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},ra=new C,oa=new C,Ad=new Jt,ar=new ui,No=new fn,Cl=new C,Td=new C,aa=class extends Ie{constructor(t=new Ae,e=new je){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)ra.fromBufferAttribute(e,s-1),oa.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=ra.distanceTo(oa);t.setAttribute("lineDistance",new he(i,1))}else Ot("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),No.copy(i.boundingSphere),No.applyMatrix4(s),No.radius+=r,t.ray.intersectsSphere(No)===!1)return;Ad.copy(s).invert(),ar.copy(t.ray).applyMatrix4(Ad);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=i.index,u=i.attributes.position;if(h!==null){let p=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let _=p,g=f-1;_<g;_+=l){let m=h.getX(_),y=h.getX(_+1),E=Oo(this,t,ar,c,m,y,_);E&&e.push(E)}if(this.isLineLoop){let _=h.getX(f-1),g=h.getX(p),m=Oo(this,t,ar,c,_,g,f-1);m&&e.push(m)}}else{let p=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let _=p,g=f-1;_<g;_+=l){let m=Oo(this,t,ar,c,_,_+1,_);m&&e.push(m)}if(this.isLineLoop){let _=Oo(this,t,ar,c,f-1,p,f-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Oo(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(ra.fromBufferAttribute(a,s),oa.fromBufferAttribute(a,r),e.distanceSqToSegment(ra,oa,Cl,Td)>i)return;Cl.applyMatrix4(n.matrixWorld);let l=t.ray.origin.distanceTo(Cl);if(!(l<t.near||l>t.far))return{distance:l,point:Td.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Cd=new C,Rd=new C,br=class extends aa{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Cd.fromBufferAttribute(e,s),Rd.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Cd.distanceTo(Rd);t.setAttribute("lineDistance",new he(i,1))}else Ot("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ls=class extends $n{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new kt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Pd=new Jt,Ol=new ui,Uo=new fn,Fo=new C,Mr=class extends Ie{constructor(t=new Ae,e=new Ls){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Uo.copy(i.boundingSphere),Uo.applyMatrix4(s),Uo.radius+=r,t.ray.intersectsSphere(Uo)===!1)return;Pd.copy(s).invert(),Ol.copy(t.ray).applyMatrix4(Pd);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=i.index,d=i.attributes.position;if(l!==null){let u=Math.max(0,o.start),p=Math.min(l.count,o.start+o.count);for(let f=u,_=p;f<_;f++){let g=l.getX(f);Fo.fromBufferAttribute(d,g),Id(Fo,g,c,s,t,e,this)}}else{let u=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let f=u,_=p;f<_;f++)Fo.fromBufferAttribute(d,f),Id(Fo,f,c,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Id(n,t,e,i,s,r,o){let a=Ol.distanceSqToPoint(n);if(a<e){let c=new C;Ol.closestPointToPoint(n,c),c.applyMatrix4(i);let l=s.ray.origin.distanceTo(c);if(l<s.near||l>s.far)return;r.push({distance:l,distanceToRay:Math.sqrt(a),point:c,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var wr=class extends ln{constructor(t=[],e=Qi,i,s,r,o,a,c,l,h){super(t,e,i,s,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Yi=class extends ln{constructor(t,e,i,s,r,o,a,c,l){super(t,e,i,s,r,o,a,c,l),this.isCanvasTexture=!0,this.needsUpdate=!0}};var di=class extends ln{constructor(t,e,i=kn,s,r,o,a=Be,c=Be,l,h=hi,d=1){if(h!==hi&&h!==mi)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:d};super(u,s,r,o,a,c,h,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Rs(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Er=class extends di{constructor(t,e=kn,i=Qi,s,r,o=Be,a=Be,c,l=hi){let h={width:t,height:t,depth:1},d=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,c,l),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Ar=class extends ln{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Ti=class n extends Ae{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],d=[],u=0,p=0;f("z","y","x",-1,-1,i,e,t,o,r,0),f("z","y","x",1,-1,i,e,-t,o,r,1),f("x","z","y",1,1,t,i,e,s,o,2),f("x","z","y",1,-1,t,i,-e,s,o,3),f("x","y","z",1,-1,t,e,i,s,r,4),f("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(c),this.setAttribute("position",new he(l,3)),this.setAttribute("normal",new he(h,3)),this.setAttribute("uv",new he(d,2));function f(_,g,m,y,E,b,T,w,x,M,D){let P=b/x,O=T/M,B=b/2,q=T/2,I=w/2,V=x+1,Y=M+1,W=0,st=0,F=new C;for(let X=0;X<Y;X++){let j=X*O-q;for(let ot=0;ot<V;ot++){let $=ot*P-B;F[_]=$*y,F[g]=j*E,F[m]=I,l.push(F.x,F.y,F.z),F[_]=0,F[g]=0,F[m]=w>0?1:-1,h.push(F.x,F.y,F.z),d.push(ot/x),d.push(1-X/M),W+=1}}for(let X=0;X<M;X++)for(let j=0;j<x;j++){let ot=u+j+V*X,$=u+j+V*(X+1),R=u+(j+1)+V*(X+1),z=u+(j+1)+V*X;c.push(ot,$,z),c.push($,R,z),st+=6}a.addGroup(p,st,D),p+=st,u+=W}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Zi=class n extends Ae{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],p=[],f=0,_=[],g=i/2,m=0;y(),o===!1&&(t>0&&E(!0),e>0&&E(!1)),this.setIndex(h),this.setAttribute("position",new he(d,3)),this.setAttribute("normal",new he(u,3)),this.setAttribute("uv",new he(p,2));function y(){let b=new C,T=new C,w=0,x=(e-t)/i;for(let M=0;M<=r;M++){let D=[],P=M/r,O=P*(e-t)+t;for(let B=0;B<=s;B++){let q=B/s,I=q*c+a,V=Math.sin(I),Y=Math.cos(I);T.x=O*V,T.y=-P*i+g,T.z=O*Y,d.push(T.x,T.y,T.z),b.set(V,x,Y).normalize(),u.push(b.x,b.y,b.z),p.push(q,1-P),D.push(f++)}_.push(D)}for(let M=0;M<s;M++)for(let D=0;D<r;D++){let P=_[D][M],O=_[D+1][M],B=_[D+1][M+1],q=_[D][M+1];(t>0||D!==0)&&(h.push(P,O,q),w+=3),(e>0||D!==r-1)&&(h.push(O,B,q),w+=3)}l.addGroup(m,w,0),m+=w}function E(b){let T=f,w=new Ut,x=new C,M=0,D=b===!0?t:e,P=b===!0?1:-1;for(let B=1;B<=s;B++)d.push(0,g*P,0),u.push(0,P,0),p.push(.5,.5),f++;let O=f;for(let B=0;B<=s;B++){let I=B/s*c+a,V=Math.cos(I),Y=Math.sin(I);x.x=D*Y,x.y=g*P,x.z=D*V,d.push(x.x,x.y,x.z),u.push(0,P,0),w.x=V*.5+.5,w.y=Y*.5*P+.5,p.push(w.x,w.y),f++}for(let B=0;B<s;B++){let q=T+B,I=O+B;b===!0?h.push(I,I+1,q):h.push(I+1,I,q),M+=3}l.addGroup(m,M,b===!0?1:2),m+=M}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Tr=class n extends Zi{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var fi=class n extends Ae{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),c=Math.floor(s),l=a+1,h=c+1,d=t/a,u=e/c,p=[],f=[],_=[],g=[];for(let m=0;m<h;m++){let y=m*u-o;for(let E=0;E<l;E++){let b=E*d-r;f.push(b,-y,0),_.push(0,0,1),g.push(E/a),g.push(1-m/c)}}for(let m=0;m<c;m++)for(let y=0;y<a;y++){let E=y+l*m,b=y+l*(m+1),T=y+1+l*(m+1),w=y+1+l*m;p.push(E,b,w),p.push(b,T,w)}this.setIndex(p),this.setAttribute("position",new he(f,3)),this.setAttribute("normal",new he(_,3)),this.setAttribute("uv",new he(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var Cr=class extends Ae{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],i=new Set,s=new C,r=new C;if(t.index!==null){let o=t.attributes.position,a=t.index,c=t.groups;c.length===0&&(c=[{start:0,count:a.count,materialIndex:0}]);for(let l=0,h=c.length;l<h;++l){let d=c[l],u=d.start,p=d.count;for(let f=u,_=u+p;f<_;f+=3)for(let g=0;g<3;g++){let m=a.getX(f+g),y=a.getX(f+(g+1)%3);s.fromBufferAttribute(o,m),r.fromBufferAttribute(o,y),Ld(s,r,i)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,c=o.count/3;a<c;a++)for(let l=0;l<3;l++){let h=3*a+l,d=3*a+(l+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,d),Ld(s,r,i)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new he(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function Ld(n,t,e){let i=`${n.x},${n.y},${n.z}-${t.x},${t.y},${t.z}`,s=`${t.x},${t.y},${t.z}-${n.x},${n.y},${n.z}`;return e.has(i)===!0||e.has(s)===!0?!1:(e.add(i),e.add(s),!0)}function es(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Dd(s))s.isRenderTargetTexture?(Ot("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Dd(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Qe(n){let t={};for(let e=0;e<n.length;e++){let i=es(n[e]);for(let s in i)t[s]=i[s]}return t}function Dd(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function T_(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function mh(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:te.workingColorSpace}var $r={clone:es,merge:Qe},C_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,R_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Cn=class extends $n{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=C_,this.fragmentShader=R_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=es(t.uniforms),this.uniformsGroups=T_(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new kt().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ut().fromArray(s.value);break;case"v3":this.uniforms[i].value=new C().fromArray(s.value);break;case"v4":this.uniforms[i].value=new ue().fromArray(s.value);break;case"m3":this.uniforms[i].value=new zt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Jt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},ca=class extends Cn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ze=class extends $n{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new kt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new kt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=uc,this.normalScale=new Ut(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Bn,this.combine=wa,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},la=class extends $n{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=pf,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},ha=class extends $n{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function ys(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Bo(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ci=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let c=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===c)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},ua=class extends Ci{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ll,endingEnd:Ll}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Dl:r=t,a=2*e-i;break;case Nl:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(c===void 0)switch(this.getSettings_().endingEnd){case Dl:o=t,c=2*i-e;break;case Nl:o=1,c=i+s[1]-s[0];break;default:o=t-1,c=e}let l=(i-e)*.5,h=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,p=this._weightNext,f=(i-e)/(s-e),_=f*f,g=_*f,m=-u*g+2*u*_-u*f,y=(1+u)*g+(-1.5-2*u)*_+(-.5+u)*f+1,E=(-1-p)*g+(1.5+p)*_+.5*f,b=p*g-p*_;for(let T=0;T!==a;++T)r[T]=m*o[h+T]+y*o[l+T]+E*o[c+T]+b*o[d+T];return r}},da=class extends Ci{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=(i-e)/(s-e),d=1-h;for(let u=0;u!==a;++u)r[u]=o[l+u]*d+o[c+u]*h;return r}},fa=class extends Ci{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},pa=class extends Ci{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let f=(i-e)/(s-e),_=1-f;for(let g=0;g!==a;++g)r[g]=o[l+g]*_+o[c+g]*f;return r}let u=a*2,p=t-1;for(let f=0;f!==a;++f){let _=o[l+f],g=o[c+f],m=p*u+f*2,y=d[m],E=d[m+1],b=t*u+f*2,T=h[b],w=h[b+1],x=I_(i,e,y,T,s);r[f]=Tf(x,_,E,w,g)}return r}};function Tf(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function P_(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function I_(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=Tf(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let c=P_(r,t,e,i,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var vn=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=ys(e,this.TimeBufferType),this.values=ys(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:ys(t.times,Array),values:ys(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Bo(t.settings)&&(i.settings={inTangents:ys(t.settings.inTangents,Array),outTangents:ys(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new fa(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new da(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new ua(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new pa(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ur:e=this.InterpolantFactoryMethodDiscrete;break;case Qo:e=this.InterpolantFactoryMethodLinear;break;case Vo:e=this.InterpolantFactoryMethodSmooth;break;case Il:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ot("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ur;case this.InterpolantFactoryMethodLinear:return Qo;case this.InterpolantFactoryMethodSmooth:return Vo;case this.InterpolantFactoryMethodBezier:return Il}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Bo(this.settings)&&(Nd(this.settings.inTangents,t),Nd(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Bo(this.settings)&&(Od(this.settings.inTangents,t),Od(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Bt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Bt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=i[a];if(typeof c=="number"&&isNaN(c)){Bt("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){Bt("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&q0(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){Bt("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Vo,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],h=t[a+1];if(l!==h&&(a!==1||l!==t[0]))if(s)c=!0;else{let d=a*i,u=d-i,p=d+i;for(let f=0;f!==i;++f){let _=e[d+f];if(_!==e[u+f]||_!==e[p+f]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let d=a*i,u=o*i;for(let p=0;p!==i;++p)e[u+p]=e[d+p]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,c=o*i,l=0;l!==i;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Bo(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Nd(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Od(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}vn.prototype.ValueTypeName="";vn.prototype.TimeBufferType=Float32Array;vn.prototype.ValueBufferType=Float32Array;vn.prototype.DefaultInterpolation=Qo;var Ri=class extends vn{constructor(t,e,i){super(t,e,i)}};Ri.prototype.ValueTypeName="bool";Ri.prototype.ValueBufferType=Array;Ri.prototype.DefaultInterpolation=ur;Ri.prototype.InterpolantFactoryMethodLinear=void 0;Ri.prototype.InterpolantFactoryMethodSmooth=void 0;var ma=class extends vn{constructor(t,e,i,s){super(t,e,i,s)}};ma.prototype.ValueTypeName="color";var ga=class extends vn{constructor(t,e,i,s){super(t,e,i,s)}};ga.prototype.ValueTypeName="number";var _a=class extends Ci{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(i-e)/(s-e),l=t*a;for(let h=l+a;l!==h;l+=4)we.slerpFlat(r,0,o,l-a,o,l,c);return r}},Rr=class extends vn{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new _a(this.times,this.values,this.getValueSize(),t)}};Rr.prototype.ValueTypeName="quaternion";Rr.prototype.InterpolantFactoryMethodSmooth=void 0;var Pi=class extends vn{constructor(t,e,i){super(t,e,i)}};Pi.prototype.ValueTypeName="string";Pi.prototype.ValueBufferType=Array;Pi.prototype.DefaultInterpolation=ur;Pi.prototype.InterpolantFactoryMethodLinear=void 0;Pi.prototype.InterpolantFactoryMethodSmooth=void 0;var xa=class extends vn{constructor(t,e,i,s){super(t,e,i,s)}};xa.prototype.ValueTypeName="vector";var ya=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,d){return l.push(h,d),this},this.removeHandler=function(h){let d=l.indexOf(h);return d!==-1&&l.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=l.length;d<u;d+=2){let p=l[d],f=l[d+1];if(p.global&&(p.lastIndex=0),p.test(h))return f}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Cf=new ya,va=class{constructor(t){this.manager=t!==void 0?t:Cf,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};va.DEFAULT_MATERIAL_NAME="__DEFAULT";var Pr=class extends Ie{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new kt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var Rl=new Jt,Ud=new C,Fd=new C,Sa=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ut(512,512),this.mapType=pn,this.map=null,this.mapPass=null,this.matrix=new Jt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Ai,this._frameExtents=new Ut(1,1),this._viewportCount=1,this._viewports=[new ue(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Ud.setFromMatrixPosition(t.matrixWorld),e.position.copy(Ud),Fd.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Fd),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){Rl.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(Rl,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===As||t.reversedDepth?e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),e.multiply(Rl)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},zo=new C,ko=new we,Xn=new C,Ir=class extends Ie{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Jt,this.projectionMatrix=new Jt,this.projectionMatrixInverse=new Jt,this.coordinateSystem=An,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(zo,ko,Xn),Xn.x===1&&Xn.y===1&&Xn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(zo,ko,Xn.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(zo,ko,Xn),Xn.x===1&&Xn.y===1&&Xn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(zo,ko,Xn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},wi=new C,Bd=new Ut,zd=new Ut,an=class extends Ir{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Cs*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(lr*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Cs*2*Math.atan(Math.tan(lr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){wi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(wi.x,wi.y).multiplyScalar(-t/wi.z),wi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(wi.x,wi.y).multiplyScalar(-t/wi.z)}getViewSize(t,e){return this.getViewBounds(t,Bd,zd),e.subVectors(zd,Bd)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(lr*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*i/l,s*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ji=class extends Ir{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Ul=class extends Sa{constructor(){super(new Ji(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Lr=class extends Pr{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ie.DEFAULT_UP),this.updateMatrix(),this.target=new Ie,this.shadow=new Ul}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Dr=class extends Pr{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var Nr=class extends Ae{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var vs=-90,Ss=1,Ds=class extends Ie{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new an(vs,Ss,t,e);s.layers=this.layers,this.add(s);let r=new an(vs,Ss,t,e);r.layers=this.layers,this.add(r);let o=new an(vs,Ss,t,e);o.layers=this.layers,this.add(o);let a=new an(vs,Ss,t,e);a.layers=this.layers,this.add(a);let c=new an(vs,Ss,t,e);c.layers=this.layers,this.add(c);let l=new an(vs,Ss,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===An)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===As)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),f=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(i,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(d,u,p),t.xr.enabled=f,i.texture.needsPMREMUpdate=!0}},ba=class extends an{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var gh="\\[\\]\\.:\\/",L_=new RegExp("["+gh+"]","g"),_h="[^"+gh+"]",D_="[^"+gh.replace("\\.","")+"]",N_=/((?:WC+[\/:])*)/.source.replace("WC",_h),O_=/(WCOD+)?/.source.replace("WCOD",D_),U_=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",_h),F_=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",_h),B_=new RegExp("^"+N_+O_+U_+F_+"$"),z_=["material","materials","bones","map"],Fl=class{constructor(t,e,i){let s=i||Se.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Se=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(L_,"")}static parseTrackName(t){let e=B_.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);z_.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=i(a.children);if(c)return c}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Ot("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let l=e.objectIndex;switch(i){case"materials":if(!t.material){Bt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Bt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Bt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Bt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Bt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){Bt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(l!==void 0){if(t[l]===void 0){Bt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;Bt("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Bt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Bt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Se.Composite=Fl;Se.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Se.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Se.prototype.GetterByBindingType=[Se.prototype._getValue_direct,Se.prototype._getValue_array,Se.prototype._getValue_arrayElement,Se.prototype._getValue_toArray];Se.prototype.SetterByBindingTypeAndVersioning=[[Se.prototype._setValue_direct,Se.prototype._setValue_direct_setNeedsUpdate,Se.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Se.prototype._setValue_array,Se.prototype._setValue_array_setNeedsUpdate,Se.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Se.prototype._setValue_arrayElement,Se.prototype._setValue_arrayElement_setNeedsUpdate,Se.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Se.prototype._setValue_fromArray,Se.prototype._setValue_fromArray_setNeedsUpdate,Se.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var A1=new Float32Array(1);var Ii=class extends ia{constructor(t,e,i=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var kd=new Jt,Or=class{constructor(t,e,i=0,s=1/0){this.ray=new ui(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Ps,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):Bt("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return kd.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(kd),this}intersectObject(t,e=!0,i=[]){return Bl(t,this,i,e),i.sort(Gd),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Bl(t[s],this,i,e);return i.sort(Gd),i}};function Gd(n,t){return n.distance-t.distance}function Bl(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Bl(r[o],t,e,!0)}}var Ns=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Wt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Wt(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Mh=class Mh{constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};Mh.prototype.isMatrix2=!0;var zl=Mh;var Vd=new C,Go=new C,bs=new C,Ms=new C,Pl=new C,k_=new C,G_=new C,Ur=class{constructor(t=new C,e=new C){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){Vd.subVectors(t,this.start),Go.subVectors(this.end,this.start);let i=Go.dot(Go);if(i===0)return 0;let r=Go.dot(Vd)/i;return e&&(r=Wt(r,0,1)),r}closestPointToPoint(t,e,i){let s=this.closestPointToPointParameter(t,e);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=k_,i=G_){let s=10000000000000001e-32,r,o,a=this.start,c=t.start,l=this.end,h=t.end;bs.subVectors(l,a),Ms.subVectors(h,c),Pl.subVectors(a,c);let d=bs.dot(bs),u=Ms.dot(Ms),p=Ms.dot(Pl);if(d<=s&&u<=s)return e.copy(a),i.copy(c),e.distanceToSquared(i);if(d<=s)r=0,o=p/u,o=Wt(o,0,1);else{let f=bs.dot(Pl);if(u<=s)o=0,r=Wt(-f/d,0,1);else{let _=bs.dot(Ms),g=d*u-_*_;g!==0?r=Wt((_*p-f*u)/g,0,1):r=0,o=(_*r+p)/u,o<0?(o=0,r=Wt(-f/d,0,1)):o>1&&(o=1,r=Wt((_-f)/d,0,1))}}return e.copy(a).addScaledVector(bs,r),i.copy(c).addScaledVector(Ms,o),e.distanceToSquared(i)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Fr=class extends Fn{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function xh(n,t,e,i){let s=V_(i);switch(e){case sh:return n*t;case Ia:return n*t/s.components*s.byteLength;case La:return n*t/s.components*s.byteLength;case Oi:return n*t*2/s.components*s.byteLength;case Da:return n*t*2/s.components*s.byteLength;case rh:return n*t*3/s.components*s.byteLength;case Vn:return n*t*4/s.components*s.byteLength;case Na:return n*t*4/s.components*s.byteLength;case kr:case Gr:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Vr:case Hr:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ua:case Ba:return Math.max(n,16)*Math.max(t,8)/4;case Oa:case Fa:return Math.max(n,8)*Math.max(t,8)/2;case za:case ka:case Va:case Ha:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ga:case Wr:case Wa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Xa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case qa:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case $a:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Ya:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Za:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Ja:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Ka:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case ja:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Qa:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case tc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case ec:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case nc:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case ic:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case sc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case rc:case oc:case ac:return Math.ceil(n/4)*Math.ceil(t/4)*16;case cc:case lc:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Xr:case hc:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function V_(n){switch(n){case pn:case th:return{byteLength:1,components:1};case Bs:case eh:case Gn:return{byteLength:2,components:1};case Ra:case Pa:return{byteLength:2,components:4};case kn:case Ca:case Rn:return{byteLength:4,components:1};case nh:case ih:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ot("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Jf(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function W_(n){let t=new WeakMap;function e(a,c){let l=a.array,h=a.usage,d=l.byteLength,u=n.createBuffer();n.bindBuffer(c,u),n.bufferData(c,l,h),a.onUploadCallback();let p;if(l instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)p=n.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)p=n.SHORT;else if(l instanceof Uint32Array)p=n.UNSIGNED_INT;else if(l instanceof Int32Array)p=n.INT;else if(l instanceof Int8Array)p=n.BYTE;else if(l instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:u,type:p,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,c,l){let h=c.array,d=c.updateRanges;if(n.bindBuffer(l,a),d.length===0)n.bufferSubData(l,0,h);else{d.sort((p,f)=>p.start-f.start);let u=0;for(let p=1;p<d.length;p++){let f=d[u],_=d[p];_.start<=f.start+f.count+1?f.count=Math.max(f.count,_.start+_.count-f.start):(++u,d[u]=_)}d.length=u+1;for(let p=0,f=d.length;p<f;p++){let _=d[p];n.bufferSubData(l,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(n.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var X_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,q_=`#ifdef USE_ALPHAHASH
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
#endif`,$_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Y_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Z_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,J_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,K_=`#ifdef USE_AOMAP
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
#endif`,j_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Q_=`#ifdef USE_BATCHING
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
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,tx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ex=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,nx=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ix=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,sx=`#ifdef USE_IRIDESCENCE
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
#endif`,rx=`#ifdef USE_BUMPMAP
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
#endif`,ox=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,ax=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,cx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,lx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,hx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ux=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,dx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,fx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,px=`#define PI 3.141592653589793
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
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
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
} // validated`,mx=`vec3 transformedNormal = objectNormal;
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
#endif`,gx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,_x=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,xx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,yx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,vx="gl_FragColor = linearToOutputTexel( gl_FragColor );",Sx=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,bx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Mx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,wx=`#ifdef USE_ENVMAP
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
#endif`,Ex=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Ax=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Tx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Cx=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Rx=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Px=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Ix=`#ifdef USE_GRADIENTMAP
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
}`,Lx=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Dx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Nx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Ox=`uniform bool receiveShadow;
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
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
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
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
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
#endif
#include <lightprobes_pars_fragment>`,Ux=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Fx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Bx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,zx=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,kx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Gx=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
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
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
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
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
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
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
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
#endif`,Vx=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
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
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
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
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
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
		return 0.5 / max( gv + gl, EPSILON );
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
		float roughness = max( material.clearcoatRoughness, 0.045 );
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
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
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
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
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
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
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
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
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
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
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
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Hx=`
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
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
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
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
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
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Wx=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Xx=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,qx=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,$x=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Yx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Zx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Jx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Kx=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,jx=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Qx=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,ty=`#if defined( USE_POINTS_UV )
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
#endif`,ey=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,ny=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,iy=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,sy=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,ry=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,oy=`#ifdef USE_MORPHTARGETS
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
#endif`,ay=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,cy=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
	#ifdef DOUBLE_SIDED
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
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,ly=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,hy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,uy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,dy=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,fy=`#ifdef USE_NORMALMAP
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
#endif`,py=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,my=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,gy=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,_y=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,xy=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,yy=`vec3 packNormalToRGB( const in vec3 normal ) {
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
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,vy=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Sy=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,by=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,My=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,wy=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Ey=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Ay=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
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
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Ty=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
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
#endif`,Cy=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
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
#endif`,Ry=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
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
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
}`,Py=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Iy=`#ifdef USE_SKINNING
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
#endif`,Ly=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Dy=`#ifdef USE_SKINNING
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
#endif`,Ny=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Oy=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Uy=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Fy=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,By=`#ifdef USE_TRANSMISSION
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
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,zy=`#ifdef USE_TRANSMISSION
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
#endif`,ky=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,Gy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,Vy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
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
#endif`,Hy=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Wy=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Xy=`uniform sampler2D t2D;
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
}`,qy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,$y=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Yy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Zy=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Jy=`#include <common>
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
}`,Ky=`#if DEPTH_PACKING == 3200
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
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,jy=`#define DISTANCE
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
}`,Qy=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,tv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,ev=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nv=`uniform float scale;
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
}`,iv=`uniform vec3 diffuse;
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
}`,sv=`#include <common>
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
}`,rv=`uniform vec3 diffuse;
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
}`,ov=`#define LAMBERT
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
}`,av=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,cv=`#define MATCAP
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
}`,lv=`#define MATCAP
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
}`,hv=`#define NORMAL
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
}`,uv=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
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
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,dv=`#define PHONG
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
}`,fv=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,pv=`#define STANDARD
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
}`,mv=`#define STANDARD
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
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
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
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
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
}`,gv=`#define TOON
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
}`,_v=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
}`,xv=`uniform float size;
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
}`,yv=`uniform vec3 diffuse;
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
}`,vv=`#include <common>
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
}`,Sv=`uniform vec3 color;
uniform float opacity;
#include <common>
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
	#include <premultiplied_alpha_fragment>
}`,bv=`uniform float rotation;
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
}`,Mv=`uniform vec3 diffuse;
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
}`,$t={alphahash_fragment:X_,alphahash_pars_fragment:q_,alphamap_fragment:$_,alphamap_pars_fragment:Y_,alphatest_fragment:Z_,alphatest_pars_fragment:J_,aomap_fragment:K_,aomap_pars_fragment:j_,batching_pars_vertex:Q_,batching_vertex:tx,begin_vertex:ex,beginnormal_vertex:nx,bsdfs:ix,iridescence_fragment:sx,bumpmap_pars_fragment:rx,clipping_planes_fragment:ox,clipping_planes_pars_fragment:ax,clipping_planes_pars_vertex:cx,clipping_planes_vertex:lx,color_fragment:hx,color_pars_fragment:ux,color_pars_vertex:dx,color_vertex:fx,common:px,defaultnormal_vertex:mx,displacementmap_pars_vertex:gx,displacementmap_vertex:_x,emissivemap_fragment:xx,emissivemap_pars_fragment:yx,colorspace_fragment:vx,colorspace_pars_fragment:Sx,envmap_fragment:bx,envmap_common_pars_fragment:Mx,envmap_pars_fragment:wx,envmap_pars_vertex:Ex,envmap_physical_pars_fragment:Ux,envmap_vertex:Ax,fog_vertex:Tx,fog_pars_vertex:Cx,fog_fragment:Rx,fog_pars_fragment:Px,gradientmap_pars_fragment:Ix,lightmap_pars_fragment:Lx,lights_lambert_fragment:Dx,lights_lambert_pars_fragment:Nx,lights_pars_begin:Ox,lights_toon_fragment:Fx,lights_toon_pars_fragment:Bx,lights_phong_fragment:zx,lights_phong_pars_fragment:kx,lights_physical_fragment:Gx,lights_physical_pars_fragment:Vx,lights_fragment_begin:Hx,lights_fragment_maps:Wx,lights_fragment_end:Xx,lightprobes_pars_fragment:qx,logdepthbuf_fragment:$x,logdepthbuf_pars_fragment:Yx,logdepthbuf_pars_vertex:Zx,logdepthbuf_vertex:Jx,map_fragment:Kx,map_pars_fragment:jx,map_particle_fragment:Qx,map_particle_pars_fragment:ty,metalnessmap_fragment:ey,metalnessmap_pars_fragment:ny,morphinstance_vertex:iy,morphcolor_vertex:sy,morphnormal_vertex:ry,morphtarget_pars_vertex:oy,morphtarget_vertex:ay,normal_fragment_begin:cy,normal_fragment_maps:ly,normal_pars_fragment:hy,normal_pars_vertex:uy,normal_vertex:dy,normalmap_pars_fragment:fy,clearcoat_normal_fragment_begin:py,clearcoat_normal_fragment_maps:my,clearcoat_pars_fragment:gy,iridescence_pars_fragment:_y,opaque_fragment:xy,packing:yy,premultiplied_alpha_fragment:vy,project_vertex:Sy,dithering_fragment:by,dithering_pars_fragment:My,roughnessmap_fragment:wy,roughnessmap_pars_fragment:Ey,shadowmap_pars_fragment:Ay,shadowmap_pars_vertex:Ty,shadowmap_vertex:Cy,shadowmask_pars_fragment:Ry,skinbase_vertex:Py,skinning_pars_vertex:Iy,skinning_vertex:Ly,skinnormal_vertex:Dy,specularmap_fragment:Ny,specularmap_pars_fragment:Oy,tonemapping_fragment:Uy,tonemapping_pars_fragment:Fy,transmission_fragment:By,transmission_pars_fragment:zy,uv_pars_fragment:ky,uv_pars_vertex:Gy,uv_vertex:Vy,worldpos_vertex:Hy,background_vert:Wy,background_frag:Xy,backgroundCube_vert:qy,backgroundCube_frag:$y,cube_vert:Yy,cube_frag:Zy,depth_vert:Jy,depth_frag:Ky,distance_vert:jy,distance_frag:Qy,equirect_vert:tv,equirect_frag:ev,linedashed_vert:nv,linedashed_frag:iv,meshbasic_vert:sv,meshbasic_frag:rv,meshlambert_vert:ov,meshlambert_frag:av,meshmatcap_vert:cv,meshmatcap_frag:lv,meshnormal_vert:hv,meshnormal_frag:uv,meshphong_vert:dv,meshphong_frag:fv,meshphysical_vert:pv,meshphysical_frag:mv,meshtoon_vert:gv,meshtoon_frag:_v,points_vert:xv,points_frag:yv,shadow_vert:vv,shadow_frag:Sv,sprite_vert:bv,sprite_frag:Mv},yt={common:{diffuse:{value:new kt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new zt},alphaMap:{value:null},alphaMapTransform:{value:new zt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new zt}},envmap:{envMap:{value:null},envMapRotation:{value:new zt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new zt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new zt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new zt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new zt},normalScale:{value:new Ut(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new zt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new zt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new zt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new zt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new kt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new kt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new zt},alphaTest:{value:0},uvTransform:{value:new zt}},sprite:{diffuse:{value:new kt(16777215)},opacity:{value:1},center:{value:new Ut(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new zt},alphaMap:{value:null},alphaMapTransform:{value:new zt},alphaTest:{value:0}}},un={basic:{uniforms:Qe([yt.common,yt.specularmap,yt.envmap,yt.aomap,yt.lightmap,yt.fog]),vertexShader:$t.meshbasic_vert,fragmentShader:$t.meshbasic_frag},lambert:{uniforms:Qe([yt.common,yt.specularmap,yt.envmap,yt.aomap,yt.lightmap,yt.emissivemap,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.fog,yt.lights,{emissive:{value:new kt(0)},envMapIntensity:{value:1}}]),vertexShader:$t.meshlambert_vert,fragmentShader:$t.meshlambert_frag},phong:{uniforms:Qe([yt.common,yt.specularmap,yt.envmap,yt.aomap,yt.lightmap,yt.emissivemap,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.fog,yt.lights,{emissive:{value:new kt(0)},specular:{value:new kt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:$t.meshphong_vert,fragmentShader:$t.meshphong_frag},standard:{uniforms:Qe([yt.common,yt.envmap,yt.aomap,yt.lightmap,yt.emissivemap,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.roughnessmap,yt.metalnessmap,yt.fog,yt.lights,{emissive:{value:new kt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:$t.meshphysical_vert,fragmentShader:$t.meshphysical_frag},toon:{uniforms:Qe([yt.common,yt.aomap,yt.lightmap,yt.emissivemap,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.gradientmap,yt.fog,yt.lights,{emissive:{value:new kt(0)}}]),vertexShader:$t.meshtoon_vert,fragmentShader:$t.meshtoon_frag},matcap:{uniforms:Qe([yt.common,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.fog,{matcap:{value:null}}]),vertexShader:$t.meshmatcap_vert,fragmentShader:$t.meshmatcap_frag},points:{uniforms:Qe([yt.points,yt.fog]),vertexShader:$t.points_vert,fragmentShader:$t.points_frag},dashed:{uniforms:Qe([yt.common,yt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:$t.linedashed_vert,fragmentShader:$t.linedashed_frag},depth:{uniforms:Qe([yt.common,yt.displacementmap]),vertexShader:$t.depth_vert,fragmentShader:$t.depth_frag},normal:{uniforms:Qe([yt.common,yt.bumpmap,yt.normalmap,yt.displacementmap,{opacity:{value:1}}]),vertexShader:$t.meshnormal_vert,fragmentShader:$t.meshnormal_frag},sprite:{uniforms:Qe([yt.sprite,yt.fog]),vertexShader:$t.sprite_vert,fragmentShader:$t.sprite_frag},background:{uniforms:{uvTransform:{value:new zt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:$t.background_vert,fragmentShader:$t.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new zt}},vertexShader:$t.backgroundCube_vert,fragmentShader:$t.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:$t.cube_vert,fragmentShader:$t.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:$t.equirect_vert,fragmentShader:$t.equirect_frag},distance:{uniforms:Qe([yt.common,yt.displacementmap,{referencePosition:{value:new C},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:$t.distance_vert,fragmentShader:$t.distance_frag},shadow:{uniforms:Qe([yt.lights,yt.fog,{color:{value:new kt(0)},opacity:{value:1}}]),vertexShader:$t.shadow_vert,fragmentShader:$t.shadow_frag}};un.physical={uniforms:Qe([un.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new zt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new zt},clearcoatNormalScale:{value:new Ut(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new zt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new zt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new zt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new zt},sheen:{value:0},sheenColor:{value:new kt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new zt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new zt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new zt},transmissionSamplerSize:{value:new Ut},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new zt},attenuationDistance:{value:0},attenuationColor:{value:new kt(0)},specularColor:{value:new kt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new zt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new zt},anisotropyVector:{value:new Ut},anisotropyMap:{value:null},anisotropyMapTransform:{value:new zt}}]),vertexShader:$t.meshphysical_vert,fragmentShader:$t.meshphysical_frag};var fc={r:0,b:0,g:0},wv=new Jt,Kf=new zt;Kf.set(-1,0,0,0,1,0,0,0,1);function Ev(n,t,e,i,s,r){let o=new kt(0),a=s===!0?0:1,c,l,h=null,d=0,u=null;function p(y){let E=y.isScene===!0?y.background:null;if(E&&E.isTexture){let b=y.backgroundBlurriness>0;E=t.get(E,b)}return E}function f(y){let E=!1,b=p(y);b===null?g(o,a):b&&b.isColor&&(g(b,1),E=!0);let T=n.xr.getEnvironmentBlendMode();T==="additive"?e.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||E)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(y,E){let b=p(E);b&&b.isCubeTexture?(l===void 0&&(l=new ne(new Ti(1,1,1),new Cn({name:"BackgroundCubeMaterial",uniforms:es(un.backgroundCube.uniforms),vertexShader:un.backgroundCube.vertexShader,fragmentShader:un.backgroundCube.fragmentShader,side:hn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(T,w,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=b,l.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(wv.makeRotationFromEuler(E.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Kf),l.material.toneMapped=te.getTransfer(b.colorSpace)!==le,(h!==b||d!==b.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,h=b,d=b.version,u=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null)):b&&b.isTexture&&(c===void 0&&(c=new ne(new fi(2,2),new Cn({name:"BackgroundMaterial",uniforms:es(un.background.uniforms),vertexShader:un.background.vertexShader,fragmentShader:un.background.fragmentShader,side:Ni,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=b,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.toneMapped=te.getTransfer(b.colorSpace)!==le,b.matrixAutoUpdate===!0&&b.updateMatrix(),c.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||d!==b.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,h=b,d=b.version,u=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null))}function g(y,E){y.getRGB(fc,mh(n)),e.buffers.color.setClear(fc.r,fc.g,fc.b,E,r)}function m(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,E=1){o.set(y),a=E,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:f,addToRenderList:_,dispose:m}}function Av(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=u(null),r=s,o=!1;function a(O,B,q,I,V){let Y=!1,W=d(O,I,q,B);r!==W&&(r=W,l(r.object)),Y=p(O,I,q,V),Y&&f(O,I,q,V),V!==null&&t.update(V,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(O,B,q,I),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function c(){return n.createVertexArray()}function l(O){return n.bindVertexArray(O)}function h(O){return n.deleteVertexArray(O)}function d(O,B,q,I){let V=I.wireframe===!0,Y=i[B.id];Y===void 0&&(Y={},i[B.id]=Y);let W=O.isInstancedMesh===!0?O.id:0,st=Y[W];st===void 0&&(st={},Y[W]=st);let F=st[q.id];F===void 0&&(F={},st[q.id]=F);let X=F[V];return X===void 0&&(X=u(c()),F[V]=X),X}function u(O){let B=[],q=[],I=[];for(let V=0;V<e;V++)B[V]=0,q[V]=0,I[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:q,attributeDivisors:I,object:O,attributes:{},index:null}}function p(O,B,q,I){let V=r.attributes,Y=B.attributes,W=0,st=q.getAttributes();for(let F in st)if(st[F].location>=0){let j=V[F],ot=Y[F];if(ot===void 0&&(F==="instanceMatrix"&&O.instanceMatrix&&(ot=O.instanceMatrix),F==="instanceColor"&&O.instanceColor&&(ot=O.instanceColor)),j===void 0||j.attribute!==ot||ot&&j.data!==ot.data)return!0;W++}return r.attributesNum!==W||r.index!==I}function f(O,B,q,I){let V={},Y=B.attributes,W=0,st=q.getAttributes();for(let F in st)if(st[F].location>=0){let j=Y[F];j===void 0&&(F==="instanceMatrix"&&O.instanceMatrix&&(j=O.instanceMatrix),F==="instanceColor"&&O.instanceColor&&(j=O.instanceColor));let ot={};ot.attribute=j,j&&j.data&&(ot.data=j.data),V[F]=ot,W++}r.attributes=V,r.attributesNum=W,r.index=I}function _(){let O=r.newAttributes;for(let B=0,q=O.length;B<q;B++)O[B]=0}function g(O){m(O,0)}function m(O,B){let q=r.newAttributes,I=r.enabledAttributes,V=r.attributeDivisors;q[O]=1,I[O]===0&&(n.enableVertexAttribArray(O),I[O]=1),V[O]!==B&&(n.vertexAttribDivisor(O,B),V[O]=B)}function y(){let O=r.newAttributes,B=r.enabledAttributes;for(let q=0,I=B.length;q<I;q++)B[q]!==O[q]&&(n.disableVertexAttribArray(q),B[q]=0)}function E(O,B,q,I,V,Y,W){W===!0?n.vertexAttribIPointer(O,B,q,V,Y):n.vertexAttribPointer(O,B,q,I,V,Y)}function b(O,B,q,I){_();let V=I.attributes,Y=q.getAttributes(),W=B.defaultAttributeValues;for(let st in Y){let F=Y[st];if(F.location>=0){let X=V[st];if(X===void 0&&(st==="instanceMatrix"&&O.instanceMatrix&&(X=O.instanceMatrix),st==="instanceColor"&&O.instanceColor&&(X=O.instanceColor)),X!==void 0){let j=X.normalized,ot=X.itemSize,$=t.get(X);if($===void 0)continue;let R=$.buffer,z=$.type,it=$.bytesPerElement,ht=z===n.INT||z===n.UNSIGNED_INT||X.gpuType===Ca;if(X.isInterleavedBufferAttribute){let rt=X.data,Ct=rt.isInterleavedBuffer===!0?rt.stride:rt.itemSize,re=X.offset;if(rt.isInstancedInterleavedBuffer||rt.isInstancedBufferAttribute){for(let It=0;It<F.locationSize;It++)m(F.location+It,rt.meshPerAttribute);O.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=rt.meshPerAttribute*rt.count)}else for(let It=0;It<F.locationSize;It++)g(F.location+It);n.bindBuffer(n.ARRAY_BUFFER,R);for(let It=0;It<F.locationSize;It++)E(F.location+It,ot/F.locationSize,z,j,Ct*it,(re+ot/F.locationSize*It)*it,ht)}else{if(X.isInstancedBufferAttribute){for(let rt=0;rt<F.locationSize;rt++)m(F.location+rt,X.meshPerAttribute);O.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=X.meshPerAttribute*X.count)}else for(let rt=0;rt<F.locationSize;rt++)g(F.location+rt);n.bindBuffer(n.ARRAY_BUFFER,R);for(let rt=0;rt<F.locationSize;rt++)E(F.location+rt,ot/F.locationSize,z,j,ot*it,ot/F.locationSize*rt*it,ht)}}else if(W!==void 0){let j=W[st];if(j!==void 0)switch(j.length){case 2:n.vertexAttrib2fv(F.location,j);break;case 3:n.vertexAttrib3fv(F.location,j);break;case 4:n.vertexAttrib4fv(F.location,j);break;default:n.vertexAttrib1fv(F.location,j)}}}}y()}function T(){D();for(let O in i){let B=i[O];for(let q in B){let I=B[q];for(let V in I){let Y=I[V];for(let W in Y)h(Y[W].object),delete Y[W];delete I[V]}}delete i[O]}}function w(O){if(i[O.id]===void 0)return;let B=i[O.id];for(let q in B){let I=B[q];for(let V in I){let Y=I[V];for(let W in Y)h(Y[W].object),delete Y[W];delete I[V]}}delete i[O.id]}function x(O){for(let B in i){let q=i[B];for(let I in q){let V=q[I];if(V[O.id]===void 0)continue;let Y=V[O.id];for(let W in Y)h(Y[W].object),delete Y[W];delete V[O.id]}}}function M(O){for(let B in i){let q=i[B],I=O.isInstancedMesh===!0?O.id:0,V=q[I];if(V!==void 0){for(let Y in V){let W=V[Y];for(let st in W)h(W[st].object),delete W[st];delete V[Y]}delete q[I],Object.keys(q).length===0&&delete i[B]}}}function D(){P(),o=!0,r!==s&&(r=s,l(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:P,dispose:T,releaseStatesOfGeometry:w,releaseStatesOfObject:M,releaseStatesOfProgram:x,initAttributes:_,enableAttribute:g,disableUnusedAttributes:y}}function Tv(n,t,e){let i;function s(c){i=c}function r(c,l){n.drawArrays(i,c,l),e.update(l,i,1)}function o(c,l,h){h!==0&&(n.drawArraysInstanced(i,c,l,h),e.update(l,i,h))}function a(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,h);let u=0;for(let p=0;p<h;p++)u+=l[p];e.update(u,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Cv(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Vn&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let M=x===Gn&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==pn&&x!==Rn&&!M&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function c(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(Ot("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&Ot("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&Ot("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),f=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),T=n.getParameter(n.MAX_SAMPLES),w=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:f,maxTextureSize:_,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:y,maxVaryings:E,maxFragmentUniforms:b,maxSamples:T,samples:w}}function Rv(n){let t=this,e=null,i=0,s=!1,r=!1,o=new He,a=new zt,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let p=d.length!==0||u||i!==0||s;return s=u,i=d.length,p},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=h(d,u,0)},this.setState=function(d,u,p){let f=d.clippingPlanes,_=d.clipIntersection,g=d.clipShadows,m=n.get(d);if(!s||f===null||f.length===0||r&&!g)r?h(null):l();else{let y=r?0:i,E=y*4,b=m.clippingState||null;c.value=b,b=h(f,u,E,p);for(let T=0;T!==E;++T)b[T]=e[T];m.clippingState=b,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=y}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(d,u,p,f){let _=d!==null?d.length:0,g=null;if(_!==0){if(g=c.value,f!==!0||g===null){let m=p+_*4,y=u.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<m)&&(g=new Float32Array(m));for(let E=0,b=p;E!==_;++E,b+=4)o.copy(d[E]).applyMatrix4(y,a),o.normal.toArray(g,b),g[b+3]=o.constant}c.value=g,c.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,g}}var Jr=class extends xn{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new wr(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Ti(5,5,5),r=new Cn({name:"CubemapFromEquirect",uniforms:es(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:hn,blending:Ki});r.uniforms.tEquirect.value=e;let o=new ne(s,r),a=e.minFilter;return e.minFilter===pi&&(e.minFilter=cn),new Ds(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Rf=256,Pv=3,Iv=20,jf=256,Qf=16,Lv=3,Dv=new C,Nv=new kt,mc=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ds(1,10,null),this._boxMesh=new ne(new Ti(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=Dv}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let d=c.autoClear,u=c.autoClearColor,p=c.autoClearDepth,f=c.autoClearStencil,_=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,_===null&&(t.background=c.getClearColor(Nv));let g=new Ds(i,s,h);return g.position.copy(a),g.update(c,t),c.autoClear=d,c.autoClearColor=u,c.autoClearDepth=p,c.autoClearStencil=f,t.background=_,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Lf(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=If(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Rf,dh(t))}_fromTexture(t,e){t.mapping===Qi||t.mapping===Fs?this._setSize(t.image.length===0?Rf:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Pf(t,!1,!1),i=Math.log2(t)-Pv;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Pf(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Qi||t.mapping===Fs?(this._cubemapMaterial===null&&(this._cubemapMaterial=Lf()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=If()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Ov(),this._integrationMaterial=Uv());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Qf);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-Lv)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(jf*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Fv());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Pf(n,t,e){return new Jr(n,{minFilter:pi,generateMipmaps:t,type:Gn,colorSpace:dr,depthBuffer:e})}function Kr(n,t,e){return new Cn({name:n,uniforms:t,vertexShader:$t.cube_vert,fragmentShader:e,side:hn,blending:Ki,depthTest:!1,depthWrite:!1})}function Ov(){return Kr("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${jf}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Uv(){return Kr("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Qf}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Fv(){return Kr("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Iv}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function If(){return Kr("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Lf(){return Kr("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Bv(n){let t=new WeakMap,e=new WeakMap,i=null;function s(u,p=!1){return u==null?null:p?o(u):r(u)}function r(u){if(u&&u.isTexture){let p=u.mapping;if(p===Ea||p===Aa)if(t.has(u)){let f=t.get(u).texture;return a(f,u.mapping)}else{let f=u.image;if(f&&f.height>0){let _=new Jr(f.height);return _.fromEquirectangularTexture(n,u),t.set(u,_),u.addEventListener("dispose",l),a(_.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let p=u.mapping,f=p===Ea||p===Aa,_=p===Qi||p===Fs;if(f||_){let g=e.get(u),m=g!==void 0?g.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==m)return i===null&&(i=new mc(n)),g=f?i.fromEquirectangular(u,g):i.fromCubemap(u,g),g.texture.pmremVersion=u.pmremVersion,e.set(u,g),g.texture;if(g!==void 0)return g.texture;{let y=u.image;return f&&y&&y.height>0||_&&y&&c(y)?(i===null&&(i=new mc(n)),g=f?i.fromEquirectangular(u):i.fromCubemap(u),g.texture.pmremVersion=u.pmremVersion,e.set(u,g),u.addEventListener("dispose",h),g.texture):null}}}return u}function a(u,p){return p===Ea?u.mapping=Qi:p===Aa&&(u.mapping=Fs),u}function c(u){let p=0,f=6;for(let _=0;_<f;_++)u[_]!==void 0&&p++;return p===f}function l(u){let p=u.target;p.removeEventListener("dispose",l);let f=t.get(p);f!==void 0&&(t.delete(p),f.dispose())}function h(u){let p=u.target;p.removeEventListener("dispose",h);let f=e.get(p);f!==void 0&&(e.delete(p),f.dispose())}function d(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function zv(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&cr("WebGLRenderer: "+i+" extension not supported."),s}}}function kv(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(f=>delete s[f]);function a(f){c(f.target)}function c(f){f.index!==null&&t.remove(f.index);for(let g in f.attributes)t.remove(f.attributes[g]);f.removeEventListener("dispose",a),delete s[f.id],o.unregister(f);let _=r.get(f);_&&(t.remove(_),r.delete(f)),i.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function l(f,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function h(f){let _=f.attributes;for(let g in _)t.update(_[g],n.ARRAY_BUFFER)}function d(f){let _=f.index,g=f.attributes.position,m=0;if(g===void 0)return;let y=_!==null?_.array.length:g.array.length/3-1,E=g.count>=65535?yr:xr,b=new E(Math.ceil(y/3)*6,1),T=b.array;if(_!==null){let x=_.array;m=_.version;for(let M=0,D=0;M<y;M+=3){let P=x[M+0],O=x[M+1],B=x[M+2];T[D++]=P,T[D++]=O,T[D++]=O,T[D++]=B,T[D++]=B,T[D++]=P}}else{m=g.version;for(let x=0,M=0;x<y;x+=3){let D=x+0,P=x+1,O=x+2;T[M++]=D,T[M++]=P,T[M++]=P,T[M++]=O,T[M++]=O,T[M++]=D}}b.version=m;let w=r.get(f);w&&t.remove(w),r.set(f,b)}function u(f){let _=r.get(f);if(_){let g=f.index;g!==null&&_.version<g.version&&d(f)}else d(f);return r.get(f)}function p(){for(let f in s){let _=s[f].deref();_!==void 0&&c(_)}}return{get:l,update:h,getWireframeAttribute:u,dispose:p}}function Gv(n,t,e){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function c(d,u){n.drawElements(i,u,r,d*o),e.update(u,i,1)}function l(d,u,p){p!==0&&(n.drawElementsInstanced(i,u,r,d*o,p),e.update(u,i,p))}function h(d,u,p){if(p===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,r,d,0,p);let _=0;for(let g=0;g<p;g++)_+=u[g];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function Vv(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:Bt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function Hv(n,t,e){let i=new WeakMap,s=new ue;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=i.get(a);if(u===void 0||u.count!==d){let D=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",D)};u!==void 0&&u.texture.dispose();let p=a.morphAttributes.position!==void 0,f=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],E=0;p===!0&&(E=1),f===!0&&(E=2),_===!0&&(E=3);let b=a.attributes.position.count*E,T=1;b>t.maxTextureSize&&(T=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let w=new Float32Array(b*T*4*d),x=new gr(w,b,T,d);x.type=Rn,x.needsUpdate=!0;let M=E*4;for(let P=0;P<d;P++){let O=g[P],B=m[P],q=y[P],I=b*T*4*P;for(let V=0;V<O.count;V++){let Y=V*M;p===!0&&(s.fromBufferAttribute(O,V),w[I+Y+0]=s.x,w[I+Y+1]=s.y,w[I+Y+2]=s.z,w[I+Y+3]=0),f===!0&&(s.fromBufferAttribute(B,V),w[I+Y+4]=s.x,w[I+Y+5]=s.y,w[I+Y+6]=s.z,w[I+Y+7]=0),_===!0&&(s.fromBufferAttribute(q,V),w[I+Y+8]=s.x,w[I+Y+9]=s.y,w[I+Y+10]=s.z,w[I+Y+11]=q.itemSize===4?s.w:1)}}u={count:d,texture:x,size:new Ut(b,T)},i.set(a,u),a.addEventListener("dispose",D)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let p=0;for(let _=0;_<l.length;_++)p+=l[_];let f=a.morphTargetsRelative?1:1-p;c.getUniforms().setValue(n,"morphTargetBaseInfluence",f),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",u.texture,e),c.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:r}}function Wv(n,t,e,i,s){let r=new WeakMap;function o(l){let h=s.render.frame,d=l.geometry,u=t.get(l,d);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let p=l.skeleton;r.get(p)!==h&&(p.update(),r.set(p,h))}return u}function a(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var Xv={[ql]:"LINEAR_TONE_MAPPING",[$l]:"REINHARD_TONE_MAPPING",[Yl]:"CINEON_TONE_MAPPING",[Zl]:"ACES_FILMIC_TONE_MAPPING",[Kl]:"AGX_TONE_MAPPING",[jl]:"NEUTRAL_TONE_MAPPING",[Jl]:"CUSTOM_TONE_MAPPING"};function qv(n,t,e,i,s,r){let o=new xn(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new Ae;h.setAttribute("position",new he([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new he([0,2,0,0,2,0],2));let d=new ca({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new ne(h,d),p=new Ji(-1,1,1,-1,0,1),f=null,_=null,g=!1,m,y=null,E=[],b=!1;this.setSize=function(T,w){o.setSize(T,w),a!==null&&a.setSize(T,w),c!==null&&c.setSize(T,w);for(let x=0;x<E.length;x++){let M=E[x];M.setSize&&M.setSize(T,w)}},this.setEffects=function(T){E=T,b=E.length>0&&E[0].isRenderPass===!0;let w=o.width,x=o.height;E.length>0&&a===null&&(a=new xn(w,x,{type:Gn,depthBuffer:!1,stencilBuffer:!1}),c=new xn(w,x,{type:Gn,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&E.some(D=>D.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&l===null&&(l=new di(w,x),r===!0&&(l.format=mi,l.type=ts)),o.dispose(),o.depthTexture=M?l:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let D=0;D<E.length;D++){let P=E[D];P.setSize&&P.setSize(w,x),M&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(l)}},this.begin=function(T,w){if(g||T.toneMapping===Yn&&E.length===0)return!1;if(y=w,w!==null){let x=w.width,M=w.height;(o.width!==x||o.height!==M)&&this.setSize(x,M)}return b===!1&&T.setRenderTarget(o),m=T.toneMapping,T.toneMapping=Yn,!0},this.hasRenderPass=function(){return b},this.end=function(T,w){T.toneMapping=m,g=!0;let x=o,M=a;for(let D=0;D<E.length;D++){let P=E[D];P.enabled!==!1&&(P.render(T,M,x,w),P.needsSwap!==!1&&(x=M,M=M===a?c:a))}if(f!==T.outputColorSpace||_!==T.toneMapping){f=T.outputColorSpace,_=T.toneMapping,d.defines={},te.getTransfer(f)===le&&(d.defines.SRGB_TRANSFER="");let D=Xv[_];D&&(d.defines[D]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=x.texture,T.setRenderTarget(y),T.render(u,p),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),d.dispose()}}var tp=new ln,ep=new di(1,1),np=new Er(1),ip=new gr,sp=new na,rp=new wr,Df=[],Nf=[],Of=new Float32Array(16),Uf=new Float32Array(9),Ff=new Float32Array(4);function ks(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Df[s];if(r===void 0&&(r=new Float32Array(s),Df[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Le(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function De(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function _c(n,t){let e=Nf[t];e===void 0&&(e=new Int32Array(t),Nf[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function $v(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function Yv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Le(e,t))return;n.uniform2fv(this.addr,t),De(e,t)}}function Zv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Le(e,t))return;n.uniform3fv(this.addr,t),De(e,t)}}function Jv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Le(e,t))return;n.uniform4fv(this.addr,t),De(e,t)}}function Kv(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Le(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),De(e,t)}else{if(Le(e,i))return;Ff.set(i),n.uniformMatrix2fv(this.addr,!1,Ff),De(e,i)}}function jv(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Le(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),De(e,t)}else{if(Le(e,i))return;Uf.set(i),n.uniformMatrix3fv(this.addr,!1,Uf),De(e,i)}}function Qv(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Le(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),De(e,t)}else{if(Le(e,i))return;Of.set(i),n.uniformMatrix4fv(this.addr,!1,Of),De(e,i)}}function tS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function eS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Le(e,t))return;n.uniform2iv(this.addr,t),De(e,t)}}function nS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Le(e,t))return;n.uniform3iv(this.addr,t),De(e,t)}}function iS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Le(e,t))return;n.uniform4iv(this.addr,t),De(e,t)}}function sS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function rS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Le(e,t))return;n.uniform2uiv(this.addr,t),De(e,t)}}function oS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Le(e,t))return;n.uniform3uiv(this.addr,t),De(e,t)}}function aS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Le(e,t))return;n.uniform4uiv(this.addr,t),De(e,t)}}function xc(n){return n.version===0&&(n.compareFunction=ch,n.needsUpdate=!0),n}function cS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=xc(ep):r=tp,e.setTexture2D(t||r,s)}function lS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||sp,s)}function hS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=xc(np):r=rp,e.setTextureCube(t||r,s)}function uS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||ip,s)}function dS(n){switch(n){case 5126:return $v;case 35664:return Yv;case 35665:return Zv;case 35666:return Jv;case 35674:return Kv;case 35675:return jv;case 35676:return Qv;case 5124:case 35670:return tS;case 35667:case 35671:return eS;case 35668:case 35672:return nS;case 35669:case 35673:return iS;case 5125:return sS;case 36294:return rS;case 36295:return oS;case 36296:return aS;case 35678:case 36198:case 36298:case 36306:case 35682:return cS;case 35679:case 36299:case 36307:return lS;case 35680:case 36300:case 36308:case 36293:return hS;case 36289:case 36303:case 36311:case 36292:return uS}}function fS(n,t){n.uniform1fv(this.addr,t)}function pS(n,t){let e=ks(t,this.size,2);n.uniform2fv(this.addr,e)}function mS(n,t){let e=ks(t,this.size,3);n.uniform3fv(this.addr,e)}function gS(n,t){let e=ks(t,this.size,4);n.uniform4fv(this.addr,e)}function _S(n,t){let e=ks(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function xS(n,t){let e=ks(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function yS(n,t){let e=ks(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function vS(n,t){n.uniform1iv(this.addr,t)}function SS(n,t){n.uniform2iv(this.addr,t)}function bS(n,t){n.uniform3iv(this.addr,t)}function MS(n,t){n.uniform4iv(this.addr,t)}function wS(n,t){n.uniform1uiv(this.addr,t)}function ES(n,t){n.uniform2uiv(this.addr,t)}function AS(n,t){n.uniform3uiv(this.addr,t)}function TS(n,t){n.uniform4uiv(this.addr,t)}function CS(n,t,e){let i=this.cache,s=t.length,r=_c(e,s);Le(i,r)||(n.uniform1iv(this.addr,r),De(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=xc(ep):o=tp;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function RS(n,t,e){let i=this.cache,s=t.length,r=_c(e,s);Le(i,r)||(n.uniform1iv(this.addr,r),De(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||sp,r[o])}function PS(n,t,e){let i=this.cache,s=t.length,r=_c(e,s);Le(i,r)||(n.uniform1iv(this.addr,r),De(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=xc(np):o=rp;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function IS(n,t,e){let i=this.cache,s=t.length,r=_c(e,s);Le(i,r)||(n.uniform1iv(this.addr,r),De(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||ip,r[o])}function LS(n){switch(n){case 5126:return fS;case 35664:return pS;case 35665:return mS;case 35666:return gS;case 35674:return _S;case 35675:return xS;case 35676:return yS;case 5124:case 35670:return vS;case 35667:case 35671:return SS;case 35668:case 35672:return bS;case 35669:case 35673:return MS;case 5125:return wS;case 36294:return ES;case 36295:return AS;case 36296:return TS;case 35678:case 36198:case 36298:case 36306:case 35682:return CS;case 35679:case 36299:case 36307:return RS;case 35680:case 36300:case 36308:case 36293:return PS;case 36289:case 36303:case 36311:case 36292:return IS}}var Ah=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=dS(e.type)}},Th=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=LS(e.type)}},Ch=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},wh=/(\w+)(\])?(\[|\.)?/g;function Bf(n,t){n.seq.push(t),n.map[t.id]=t}function DS(n,t,e){let i=n.name,s=i.length;for(wh.lastIndex=0;;){let r=wh.exec(i),o=wh.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){Bf(e,l===void 0?new Ah(a,n,t):new Th(a,n,t));break}else{let d=e.map[a];d===void 0&&(d=new Ch(a),Bf(e,d)),e=d}}}var zs=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);DS(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=i[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function zf(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var NS=37297,OS=0;function US(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var kf=new zt;function FS(n){te._getMatrix(kf,te.workingColorSpace,n);let t=`mat3( ${kf.elements.map(e=>e.toFixed(4))} )`;switch(te.getTransfer(n)){case fr:return[t,"LinearTransferOETF"];case le:return[t,"sRGBTransferOETF"];default:return Ot("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Gf(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+US(n.getShaderSource(t),a)}else return r}function BS(n,t){let e=FS(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var zS={[ql]:"Linear",[$l]:"Reinhard",[Yl]:"Cineon",[Zl]:"ACESFilmic",[Kl]:"AgX",[jl]:"Neutral",[Jl]:"Custom"};function kS(n,t){let e=zS[t];return e===void 0?(Ot("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var pc=new C;function GS(){te.getLuminanceCoefficients(pc);let n=pc.x.toFixed(4),t=pc.y.toFixed(4),e=pc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function VS(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Zr).join(`
`)}function HS(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function WS(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Zr(n){return n!==""}function Vf(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Hf(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var XS=/^[ \t]*#include +<([\w\d./]+)>/gm;function Rh(n){return n.replace(XS,qS)}function qS(n,t){let e=$t[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Rh(e)}var $S=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Wf(n){return n.replace($S,YS)}function YS(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Xf(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var ZS={[Br]:"SHADOWMAP_TYPE_PCF",[Os]:"SHADOWMAP_TYPE_VSM"};function JS(n){return ZS[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var KS={[Fs]:"ENVMAP_MODE_REFRACTION"};function jS(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":KS[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var QS={[wa]:"ENVMAP_BLENDING_MULTIPLY",[uf]:"ENVMAP_BLENDING_MIX",[df]:"ENVMAP_BLENDING_ADD"};function tb(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":QS[n.combine]||"ENVMAP_BLENDING_NONE"}function eb(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=JS(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=jS(e),d=tb(e),u=VS(e),p=HS(r),f=s.createProgram(),_,g,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(Zr).join(`
`),_.length>0&&(_+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(Zr).join(`
`),g.length>0&&(g+=`
`)):(_=[Xf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Zr).join(`
`),g=[Xf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Yn?"#define TONE_MAPPING":"",e.toneMapping!==Yn?$t.tonemapping_pars_fragment:"",e.toneMapping!==Yn?kS("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",$t.colorspace_pars_fragment,BS("linearToOutputTexel",e.outputColorSpace),GS(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Zr).join(`
`)),o=Rh(o),o=Vf(o,e),o=Hf(o,e),a=Rh(a),a=Vf(a,e),a=Hf(a,e),o=Wf(o),a=Wf(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,_=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,g=["#define varying in",e.glslVersion===hh?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===hh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=m+_+o,E=m+g+a,b=zf(s,s.VERTEX_SHADER,y),T=zf(s,s.FRAGMENT_SHADER,E);s.attachShader(f,b),s.attachShader(f,T),e.index0AttributeName!==void 0?s.bindAttribLocation(f,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(f,0,"position"),s.linkProgram(f);function w(P){if(n.debug.checkShaderErrors){let O=s.getProgramInfoLog(f)||"",B=s.getShaderInfoLog(b)||"",q=s.getShaderInfoLog(T)||"",I=O.trim(),V=B.trim(),Y=q.trim(),W=!0,st=!0;if(s.getProgramParameter(f,s.LINK_STATUS)===!1)if(W=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,f,b,T);else{let F=Gf(s,b,"vertex"),X=Gf(s,T,"fragment");Bt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(f,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+I+`
`+F+`
`+X)}else I!==""?Ot("WebGLProgram: Program Info Log:",I):(V===""||Y==="")&&(st=!1);st&&(P.diagnostics={runnable:W,programLog:I,vertexShader:{log:V,prefix:_},fragmentShader:{log:Y,prefix:g}})}s.deleteShader(b),s.deleteShader(T),x=new zs(s,f),M=WS(s,f)}let x;this.getUniforms=function(){return x===void 0&&w(this),x};let M;this.getAttributes=function(){return M===void 0&&w(this),M};let D=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(f,NS)),D},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(f),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=OS++,this.cacheKey=t,this.usedTimes=1,this.program=f,this.vertexShader=b,this.fragmentShader=T,this}var nb=0,Ph=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Ih(t),e.set(t,i)),i}},Ih=class{constructor(t){this.id=nb++,this.code=t,this.usedTimes=0}};function ib(n){return n===Oi||n===Wr||n===Xr}function sb(n,t,e,i,s,r){let o=new Ps,a=new Ph,c=new Set,l=[],h=new Map,d=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(x){return c.add(x),x===0?"uv":`uv${x}`}function f(x,M,D,P,O,B){let q=P.fog,I=O.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?P.environment:null,Y=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,W=t.get(x.envMap||V,Y),st=u[x.type],F=i.precision;x.precision!==null&&(F=i.getMaxPrecision(x.precision),F!==x.precision&&Ot("WebGLProgram.getParameters:",x.precision,"not supported, using",F,"instead."));let X=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,j=X!==void 0?X.length:0,ot=0;I.morphAttributes.position!==void 0&&(ot=1),I.morphAttributes.normal!==void 0&&(ot=2),I.morphAttributes.color!==void 0&&(ot=3);let $,R,z,it;if(st){let bt=un[st];$=bt.vertexShader,R=bt.fragmentShader}else{$=x.vertexShader,R=x.fragmentShader;let bt=a.getVertexShaderStage(x),fe=a.getFragmentShaderStage(x);a.update(x,bt,fe),z=bt.id,it=fe.id}let ht=n.getRenderTarget(),rt=n.state.buffers.depth.getReversed(),Ct=O.isInstancedMesh===!0,re=O.isBatchedMesh===!0,It=!!x.map,Kt=!!x.matcap,oe=!!W,Zt=oe&&W.isPMREMTexture===!0,Re=!!x.aoMap,Ee=!!x.lightMap,en=!!x.bumpMap&&x.wireframe===!1,J=!!x.normalMap,vt=!!x.displacementMap,lt=!!x.emissiveMap,Lt=!!x.metalnessMap,Yt=!!x.roughnessMap,be=x.anisotropy>0,U=x.clearcoat>0,nn=x.diffuseRoughness>0,de=x.dispersion>0,xe=x.retroreflectivity>0,St=x.iridescence>0,Pe=x.sheen>0,Ft=x.transmission>0,Gt=be&&!!x.anisotropyMap,A=U&&!!x.clearcoatMap,v=U&&!!x.clearcoatNormalMap,G=U&&!!x.clearcoatRoughnessMap,at=nn&&!!x.diffuseRoughnessMap,nt=St&&!!x.iridescenceMap,dt=St&&!!x.iridescenceThicknessMap,_t=Pe&&!!x.sheenColorMap,Q=Pe&&!!x.sheenRoughnessMap,tt=!!x.specularMap,pt=!!x.specularColorMap,L=!!x.specularIntensityMap,et=Ft&&!!x.transmissionMap,K=Ft&&!!x.thicknessMap,mt=!!x.gradientMap,ut=!!x.alphaMap,ft=x.alphaTest>0,Pt=!!x.alphaHash,qt=!!x.extensions,ct=Yn;x.toneMapped&&(ht===null||ht.isXRRenderTarget===!0)&&(ct=n.toneMapping);let Nt=Zt?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,Xt={shaderID:st,shaderType:x.type,shaderName:x.name,vertexShader:$,fragmentShader:R,defines:x.defines,customVertexShaderID:z,customFragmentShaderID:it,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:F,batching:re,batchingColor:re&&O._colorsTexture!==null,instancing:Ct,instancingColor:Ct&&O.instanceColor!==null,instancingMorph:Ct&&O.morphTexture!==null,outputColorSpace:ht===null?n.outputColorSpace:ht.isXRRenderTarget===!0?ht.texture.colorSpace:te.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:It,matcap:Kt,envMap:oe,envMapMode:oe&&W.mapping,envMapPMREM:Zt,envMapMaxLod:Zt?Nt.length-1:null,envMapSize:Zt?Nt[0].width:null,aoMap:Re,lightMap:Ee,bumpMap:en,normalMap:J,displacementMap:vt,emissiveMap:lt,normalMapObjectSpace:J&&x.normalMapType===mf,normalMapTangentSpace:J&&x.normalMapType===uc,packedNormalMap:J&&x.normalMapType===uc&&ib(x.normalMap.format),metalnessMap:Lt,roughnessMap:Yt,anisotropy:be,anisotropyMap:Gt,clearcoat:U,clearcoatMap:A,clearcoatNormalMap:v,clearcoatRoughnessMap:G,diffuseRoughness:nn,diffuseRoughnessMap:at,dispersion:de,retroreflection:xe,iridescence:St,iridescenceMap:nt,iridescenceThicknessMap:dt,sheen:Pe,sheenColorMap:_t,sheenRoughnessMap:Q,specularMap:tt,specularColorMap:pt,specularIntensityMap:L,transmission:Ft,transmissionMap:et,thicknessMap:K,gradientMap:mt,opaque:x.transparent===!1&&x.blending===Us&&x.alphaToCoverage===!1,alphaMap:ut,alphaTest:ft,alphaHash:Pt,combine:x.combine,mapUv:It&&p(x.map.channel),aoMapUv:Re&&p(x.aoMap.channel),lightMapUv:Ee&&p(x.lightMap.channel),bumpMapUv:en&&p(x.bumpMap.channel),normalMapUv:J&&p(x.normalMap.channel),displacementMapUv:vt&&p(x.displacementMap.channel),emissiveMapUv:lt&&p(x.emissiveMap.channel),metalnessMapUv:Lt&&p(x.metalnessMap.channel),roughnessMapUv:Yt&&p(x.roughnessMap.channel),anisotropyMapUv:Gt&&p(x.anisotropyMap.channel),clearcoatMapUv:A&&p(x.clearcoatMap.channel),clearcoatNormalMapUv:v&&p(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:G&&p(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:at&&p(x.diffuseRoughnessMap.channel),iridescenceMapUv:nt&&p(x.iridescenceMap.channel),iridescenceThicknessMapUv:dt&&p(x.iridescenceThicknessMap.channel),sheenColorMapUv:_t&&p(x.sheenColorMap.channel),sheenRoughnessMapUv:Q&&p(x.sheenRoughnessMap.channel),specularMapUv:tt&&p(x.specularMap.channel),specularColorMapUv:pt&&p(x.specularColorMap.channel),specularIntensityMapUv:L&&p(x.specularIntensityMap.channel),transmissionMapUv:et&&p(x.transmissionMap.channel),thicknessMapUv:K&&p(x.thicknessMap.channel),alphaMapUv:ut&&p(x.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(J||be),vertexNormals:!!I.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:O.isPoints===!0&&!!I.attributes.uv&&(It||ut),fog:!!q,useFog:x.fog===!0,fogExp2:!!q&&q.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||I.attributes.normal===void 0&&J===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:rt,skinning:O.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:j,morphTextureStride:ot,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:B.filter(bt=>bt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&D.length>0,shadowMapType:n.shadowMap.type,toneMapping:ct,decodeVideoTexture:It&&x.map.isVideoTexture===!0&&te.getTransfer(x.map.colorSpace)===le,decodeVideoTextureEmissive:lt&&x.emissiveMap.isVideoTexture===!0&&te.getTransfer(x.emissiveMap.colorSpace)===le,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===ke,flipSided:x.side===hn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:qt&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(qt&&x.extensions.multiDraw===!0||re)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Xt.vertexUv1s=c.has(1),Xt.vertexUv2s=c.has(2),Xt.vertexUv3s=c.has(3),c.clear(),Xt}function _(x){let M=[];if(x.shaderID?M.push(x.shaderID):(M.push(x.customVertexShaderID),M.push(x.customFragmentShaderID)),x.defines!==void 0)for(let D in x.defines)M.push(D),M.push(x.defines[D]);return x.isRawShaderMaterial===!1&&(g(M,x),m(M,x),M.push(n.outputColorSpace)),M.push(x.customProgramCacheKey),M.join()}function g(x,M){x.push(M.precision),x.push(M.outputColorSpace),x.push(M.envMapMode),x.push(M.envMapPMREM),x.push(M.envMapMaxLod),x.push(M.envMapSize),x.push(M.mapUv),x.push(M.alphaMapUv),x.push(M.lightMapUv),x.push(M.aoMapUv),x.push(M.bumpMapUv),x.push(M.normalMapUv),x.push(M.displacementMapUv),x.push(M.emissiveMapUv),x.push(M.metalnessMapUv),x.push(M.roughnessMapUv),x.push(M.anisotropyMapUv),x.push(M.clearcoatMapUv),x.push(M.clearcoatNormalMapUv),x.push(M.clearcoatRoughnessMapUv),x.push(M.diffuseRoughnessMapUv),x.push(M.iridescenceMapUv),x.push(M.iridescenceThicknessMapUv),x.push(M.sheenColorMapUv),x.push(M.sheenRoughnessMapUv),x.push(M.specularMapUv),x.push(M.specularColorMapUv),x.push(M.specularIntensityMapUv),x.push(M.transmissionMapUv),x.push(M.thicknessMapUv),x.push(M.combine),x.push(M.fogExp2),x.push(M.sizeAttenuation),x.push(M.morphTargetsCount),x.push(M.numSunLights),x.push(M.numDirLights),x.push(M.numPointLights),x.push(M.numSpotLights),x.push(M.numSpotLightMaps),x.push(M.numHemiLights),x.push(M.numRectAreaLights),x.push(M.numSunLightShadows),x.push(M.numDirLightShadows),x.push(M.numPointLightShadows),x.push(M.numSpotLightShadows),x.push(M.numSpotLightShadowsWithMaps),x.push(M.numLightProbes),x.push(M.numLightProbeGrids),x.push(M.shadowMapType),x.push(M.toneMapping),x.push(M.numClippingPlanes),x.push(M.numClipIntersection),x.push(M.depthPacking)}function m(x,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let M=u[x.type],D;if(M){let P=un[M];D=$r.clone(P.uniforms)}else D=x.uniforms;return D}function E(x,M){let D=h.get(M);return D!==void 0?++D.usedTimes:(D=new eb(n,M,x,s),l.push(D),h.set(M,D)),D}function b(x){if(--x.usedTimes===0){let M=l.indexOf(x);l[M]=l[l.length-1],l.pop(),h.delete(x.cacheKey),x.destroy()}}function T(x){a.remove(x)}function w(){a.dispose()}return{getParameters:f,getProgramCacheKey:_,getUniforms:y,acquireProgram:E,releaseProgram:b,releaseShaderCache:T,programs:l,dispose:w}}function rb(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,c){n.get(o)[a]=c}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function ob(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function qf(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function $f(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(u){let p=0;return u.isInstancedMesh&&(p+=2),u.isSkinnedMesh&&(p+=1),p}function a(u,p,f,_,g,m){let y=n[t];return y===void 0?(y={id:u.id,object:u,geometry:p,material:f,materialVariant:o(u),groupOrder:_,renderOrder:u.renderOrder,z:g,group:m},n[t]=y):(y.id=u.id,y.object=u,y.geometry=p,y.material=f,y.materialVariant=o(u),y.groupOrder=_,y.renderOrder=u.renderOrder,y.z=g,y.group=m),t++,y}function c(u,p,f,_,g,m,y){y.reversedDepth===!0&&(g=-g);let E=a(u,p,f,_,g,m);f.transmission>0?i.push(E):f.transparent===!0?s.push(E):e.push(E)}function l(u,p,f,_,g,m){let y=a(u,p,f,_,g,m);f.transmission>0?i.unshift(y):f.transparent===!0?s.unshift(y):e.unshift(y)}function h(u,p){e.length>1&&e.sort(u||ob),i.length>1&&i.sort(p||qf),s.length>1&&s.sort(p||qf)}function d(){for(let u=t,p=n.length;u<p;u++){let f=n[u];if(f.id===null)break;f.id=null,f.object=null,f.geometry=null,f.material=null,f.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:c,unshift:l,finish:d,sort:h}}function ab(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new $f,n.set(i,[o])):s>=r.length?(o=new $f,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function cb(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new C,color:new kt};break;case"SpotLight":e={position:new C,direction:new C,color:new kt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new C,color:new kt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new C,skyColor:new kt,groundColor:new kt};break;case"RectAreaLight":e={color:new kt,position:new C,halfWidth:new C,halfHeight:new C};break}return n[t.id]=e,e}}}function lb(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ut};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ut};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ut,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var hb=0;function ub(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function db(n){let t=new cb,e=lb(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new C);let s=new C,r=new Jt,o=new Jt;function a(l){let h=0,d=0,u=0;for(let B=0;B<9;B++)i.probe[B].set(0,0,0);let p=0,f=0,_=0,g=0,m=0,y=0,E=0,b=0,T=0,w=0,x=0,M=0,D=0,P=0;l.sort(ub);for(let B=0,q=l.length;B<q;B++){let I=l[B],V=I.color,Y=I.intensity,W=I.distance,st=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===Oi?st=I.shadow.map.texture:st=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=V.r*Y,d+=V.g*Y,u+=V.b*Y;else if(I.isLightProbe){for(let F=0;F<9;F++)i.probe[F].addScaledVector(I.sh.coefficients[F],Y);P++}else if(I.isSunLight){let F=t.get(I);if(F.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let X=I.shadow,j=e.get(I);j.shadowIntensity=X.intensity,j.shadowBias=X.bias,j.shadowNormalBias=X.normalBias,j.shadowRadius=X.radius,j.shadowMapSize.copy(X.mapSize).multiply(X.getFrameExtents()),i.sunShadow[f]=j,i.sunShadowMap[f]=st;let ot=X.getViewportCount();for(let $=0;$<ot;$++)i.sunShadowMatrix[_+$]=X.getMatrix($),i.sunShadowCascade[_+$]=X._cascadeData[$];_+=ot,f++}i.sun[p]=F,p++}else if(I.isDirectionalLight){let F=t.get(I);if(F.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let X=I.shadow,j=e.get(I);j.shadowIntensity=X.intensity,j.shadowBias=X.bias,j.shadowNormalBias=X.normalBias,j.shadowRadius=X.radius,j.shadowMapSize=X.mapSize,i.directionalShadow[g]=j,i.directionalShadowMap[g]=st,i.directionalShadowMatrix[g]=I.shadow.matrix,T++}i.directional[g]=F,g++}else if(I.isSpotLight){let F=t.get(I);F.position.setFromMatrixPosition(I.matrixWorld),F.color.copy(V).multiplyScalar(Y),F.distance=W,F.coneCos=Math.cos(I.angle),F.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),F.decay=I.decay,i.spot[y]=F;let X=I.shadow;if(I.map&&(i.spotLightMap[M]=I.map,M++,X.updateMatrices(I),I.castShadow&&D++),i.spotLightMatrix[y]=X.matrix,I.castShadow){let j=e.get(I);j.shadowIntensity=X.intensity,j.shadowBias=X.bias,j.shadowNormalBias=X.normalBias,j.shadowRadius=X.radius,j.shadowMapSize=X.mapSize,i.spotShadow[y]=j,i.spotShadowMap[y]=st,x++}y++}else if(I.isRectAreaLight){let F=t.get(I);F.color.copy(V).multiplyScalar(Y),F.halfWidth.set(I.width*.5,0,0),F.halfHeight.set(0,I.height*.5,0),i.rectArea[E]=F,E++}else if(I.isPointLight){let F=t.get(I);if(F.color.copy(I.color).multiplyScalar(I.intensity),F.distance=I.distance,F.decay=I.decay,I.castShadow){let X=I.shadow,j=e.get(I);j.shadowIntensity=X.intensity,j.shadowBias=X.bias,j.shadowNormalBias=X.normalBias,j.shadowRadius=X.radius,j.shadowMapSize=X.mapSize,j.shadowCameraNear=X.camera.near,j.shadowCameraFar=X.camera.far,i.pointShadow[m]=j,i.pointShadowMap[m]=st,i.pointShadowMatrix[m]=I.shadow.matrix,w++}i.point[m]=F,m++}else if(I.isHemisphereLight){let F=t.get(I);F.skyColor.copy(I.color).multiplyScalar(Y),F.groundColor.copy(I.groundColor).multiplyScalar(Y),i.hemi[b]=F,b++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=yt.LTC_FLOAT_1,i.rectAreaLTC2=yt.LTC_FLOAT_2):(i.rectAreaLTC1=yt.LTC_HALF_1,i.rectAreaLTC2=yt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=d,i.ambient[2]=u;let O=i.hash;(O.sunLength!==p||O.directionalLength!==g||O.pointLength!==m||O.spotLength!==y||O.rectAreaLength!==E||O.hemiLength!==b||O.numSunShadows!==f||O.numDirectionalShadows!==T||O.numPointShadows!==w||O.numSpotShadows!==x||O.numSpotMaps!==M||O.numLightProbes!==P)&&(i.sun.length=p,i.directional.length=g,i.spot.length=y,i.rectArea.length=E,i.point.length=m,i.hemi.length=b,i.sunShadow.length=f,i.sunShadowMap.length=f,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=T,i.directionalShadowMap.length=T,i.directionalShadowMatrix.length=T,i.pointShadow.length=w,i.pointShadowMap.length=w,i.pointShadowMatrix.length=w,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+M-D,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=D,i.numLightProbes=P,O.sunLength=p,O.directionalLength=g,O.pointLength=m,O.spotLength=y,O.rectAreaLength=E,O.hemiLength=b,O.numSunShadows=f,O.numDirectionalShadows=T,O.numPointShadows=w,O.numSpotShadows=x,O.numSpotMaps=M,O.numLightProbes=P,i.version=hb++)}function c(l,h){let d=0,u=0,p=0,f=0,_=0,g=0,m=h.matrixWorldInverse;for(let y=0,E=l.length;y<E;y++){let b=l[y];if(b.isSunLight){let T=i.sun[d];T.direction.setFromMatrixPosition(b.matrixWorld),T.direction.transformDirection(m),d++}else if(b.isDirectionalLight){let T=i.directional[u];T.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(m),u++}else if(b.isSpotLight){let T=i.spot[f];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(m),T.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(m),f++}else if(b.isRectAreaLight){let T=i.rectArea[_];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),T.halfWidth.set(b.width*.5,0,0),T.halfHeight.set(0,b.height*.5,0),T.halfWidth.applyMatrix4(o),T.halfHeight.applyMatrix4(o),_++}else if(b.isPointLight){let T=i.point[p];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(m),p++}else if(b.isHemisphereLight){let T=i.hemi[g];T.direction.setFromMatrixPosition(b.matrixWorld),T.direction.transformDirection(m),g++}}}return{setup:a,setupView:c,state:i}}function Yf(n){let t=new db(n),e=[],i=[],s=[];function r(d){h.camera=d,e.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){i.push(d)}function c(){t.setup(e),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function l(d){t.setupView(e,d)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function fb(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Yf(n),t.set(s,[a])):r>=o.length?(a=new Yf(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var pb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,mb=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,gb=[new C(1,0,0),new C(-1,0,0),new C(0,1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1)],_b=[new C(0,-1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1),new C(0,-1,0),new C(0,-1,0)],Zf=new Jt,Yr=new C,Eh=new C;function xb(n,t,e){let i=new Ai,s=new Ut,r=new Ut,o=new ue,a=new la,c=new ha,l={},h=e.maxTextureSize,d={[Ni]:hn,[hn]:Ni,[ke]:ke},u=new Cn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ut},radius:{value:4}},vertexShader:pb,fragmentShader:mb}),p=u.clone();p.defines.HORIZONTAL_PASS=1;let f=new Ae;f.setAttribute("position",new Tn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new ne(f,u),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Br;let m=this.type;this.render=function(w,x,M){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||w.length===0)return;this.type===Xd&&(Ot("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Br);let D=n.getRenderTarget(),P=n.getActiveCubeFace(),O=n.getActiveMipmapLevel(),B=n.state;B.setBlending(Ki),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let q=m!==this.type;q&&x.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(V=>V.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,V=w.length;I<V;I++){let Y=w[I],W=Y.shadow;if(W===void 0){Ot("WebGLShadowMap:",Y,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let st=W.getFrameExtents();s.multiply(st),r.copy(W.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/st.x),s.x=r.x*st.x,W.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/st.y),s.y=r.y*st.y,W.mapSize.y=r.y));let F=n.state.buffers.depth.getReversed();if(W.camera._reversedDepth=F,W.map===null||q===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===Os){if(Y.isPointLight){Ot("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new xn(s.x,s.y,{format:Oi,type:Gn,minFilter:cn,magFilter:cn,generateMipmaps:!1}),W.map.texture.name=Y.name+".shadowMap",W.map.depthTexture=new di(s.x,s.y,Rn),W.map.depthTexture.name=Y.name+".shadowMapDepth",W.map.depthTexture.format=hi,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Be,W.map.depthTexture.magFilter=Be}else Y.isPointLight?(W.map=new Jr(s.x),W.map.depthTexture=new Er(s.x,kn)):(W.map=new xn(s.x,s.y),W.map.depthTexture=new di(s.x,s.y,kn)),W.map.depthTexture.name=Y.name+".shadowMap",W.map.depthTexture.format=hi,this.type===Br?(W.map.depthTexture.compareFunction=F?ah:oh,W.map.depthTexture.minFilter=cn,W.map.depthTexture.magFilter=cn):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Be,W.map.depthTexture.magFilter=Be);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let X=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();Y.isPointLight!==!0&&W.updateMatrices(Y,M);let j=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:M.layers;for(let ot=0;ot<X;ot++){let $=W.getCamera(ot);if(Y.isPointLight){let R=W.camera,z=W.matrix,it=Y.distance||R.far;it!==R.far&&(R.far=it,R.updateProjectionMatrix()),Yr.setFromMatrixPosition(Y.matrixWorld),R.position.copy(Yr),Eh.copy(R.position),Eh.add(gb[ot]),R.up.copy(_b[ot]),R.lookAt(Eh),R.updateMatrixWorld(),z.makeTranslation(-Yr.x,-Yr.y,-Yr.z),Zf.multiplyMatrices(R.projectionMatrix,R.matrixWorldInverse),W._frustum.setFromProjectionMatrix(Zf,R.coordinateSystem,R.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)n.setRenderTarget(W.map,ot),n.clear();else{ot===0&&(n.setRenderTarget(W.map),n.clear());let R=W.getViewport(ot);o.set(r.x*R.x,r.y*R.y,r.x*R.z,r.y*R.w),B.viewport(o)}i=W.getFrustum(ot),b(x,M,$,Y,j,this.type)}W.isPointLightShadow!==!0&&this.type===Os&&y(W,M),W.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(D,P,O)};function y(w,x){let M=t.update(_);u.defines.VSM_SAMPLES!==w.blurSamples&&(u.defines.VSM_SAMPLES=w.blurSamples,p.defines.VSM_SAMPLES=w.blurSamples,u.needsUpdate=!0,p.needsUpdate=!0),w.mapPass===null?w.mapPass=new xn(s.x,s.y,{format:Oi,type:Gn}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),u.uniforms.shadow_pass.value=w.map.depthTexture,u.uniforms.resolution.value.set(w.map.width,w.map.height),u.uniforms.radius.value=w.radius,n.setRenderTarget(w.mapPass),n.clear(),n.renderBufferDirect(x,null,M,u,_,null),p.uniforms.shadow_pass.value=w.mapPass.texture,p.uniforms.resolution.value.set(w.map.width,w.map.height),p.uniforms.radius.value=w.radius,n.setRenderTarget(w.map),n.clear(),n.renderBufferDirect(x,null,M,p,_,null)}function E(w,x,M,D){let P=null,O=M.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(O!==void 0)P=O;else if(P=M.isPointLight===!0?c:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let B=P.uuid,q=x.uuid,I=l[B];I===void 0&&(I={},l[B]=I);let V=I[q];V===void 0&&(V=P.clone(),I[q]=V,x.addEventListener("dispose",T)),P=V}if(P.visible=x.visible,P.wireframe=x.wireframe,D===Os?P.side=x.shadowSide!==null?x.shadowSide:x.side:P.side=x.shadowSide!==null?x.shadowSide:d[x.side],P.alphaMap=x.alphaMap,P.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,P.map=x.map,P.clipShadows=x.clipShadows,P.clippingPlanes=x.clippingPlanes,P.clipIntersection=x.clipIntersection,P.displacementMap=x.displacementMap,P.displacementScale=x.displacementScale,P.displacementBias=x.displacementBias,P.wireframeLinewidth=x.wireframeLinewidth,P.linewidth=x.linewidth,M.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let B=n.properties.get(P);B.light=M}return P}function b(w,x,M,D,P,O){if(w.visible===!1)return;if(w.layers.test(P)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&O===Os)&&(!w.frustumCulled||w.intersectsFrustum(i))){w.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,w.matrixWorld);let I=t.update(w),V=w.material;if(Array.isArray(V)){let Y=I.groups;for(let W=0,st=Y.length;W<st;W++){let F=Y[W],X=V[F.materialIndex];if(X&&X.visible){let j=E(w,X,D,O);w.onBeforeShadow(n,w,x,M,I,j,F),n.renderBufferDirect(M,null,I,j,w,F),w.onAfterShadow(n,w,x,M,I,j,F)}}}else if(V.visible){let Y=E(w,V,D,O);w.onBeforeShadow(n,w,x,M,I,Y,null),n.renderBufferDirect(M,null,I,Y,w,null),w.onAfterShadow(n,w,x,M,I,Y,null)}}let q=w.children;for(let I=0,V=q.length;I<V;I++)b(q[I],x,M,D,P,O)}function T(w){w.target.removeEventListener("dispose",T);for(let M in l){let D=l[M],P=w.target.uuid;P in D&&(D[P].dispose(),delete D[P])}}}function yb(n,t){function e(){let L=!1,et=new ue,K=null,mt=new ue(0,0,0,0);return{setMask:function(ut){K!==ut&&!L&&(n.colorMask(ut,ut,ut,ut),K=ut)},setLocked:function(ut){L=ut},setClear:function(ut,ft,Pt,qt,ct){ct===!0&&(ut*=qt,ft*=qt,Pt*=qt),et.set(ut,ft,Pt,qt),mt.equals(et)===!1&&(n.clearColor(ut,ft,Pt,qt),mt.copy(et))},reset:function(){L=!1,K=null,mt.set(-1,0,0,0)}}}function i(){let L=!1,et=!1,K=null,mt=null,ut=null;return{setReversed:function(ft){if(et!==ft){let Pt=t.get("EXT_clip_control");ft?Pt.clipControlEXT(Pt.LOWER_LEFT_EXT,Pt.ZERO_TO_ONE_EXT):Pt.clipControlEXT(Pt.LOWER_LEFT_EXT,Pt.NEGATIVE_ONE_TO_ONE_EXT),et=ft;let qt=ut;ut=null,this.setClear(qt)}},getReversed:function(){return et},setTest:function(ft){ft?rt(n.DEPTH_TEST):Ct(n.DEPTH_TEST)},setMask:function(ft){K!==ft&&!L&&(n.depthMask(ft),K=ft)},setFunc:function(ft){if(et&&(ft=Ef[ft]),mt!==ft){switch(ft){case Wo:n.depthFunc(n.NEVER);break;case Xo:n.depthFunc(n.ALWAYS);break;case qo:n.depthFunc(n.LESS);break;case Es:n.depthFunc(n.LEQUAL);break;case $o:n.depthFunc(n.EQUAL);break;case Yo:n.depthFunc(n.GEQUAL);break;case Zo:n.depthFunc(n.GREATER);break;case Jo:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}mt=ft}},setLocked:function(ft){L=ft},setClear:function(ft){ut!==ft&&(ut=ft,et&&(ft=1-ft),n.clearDepth(ft))},reset:function(){L=!1,K=null,mt=null,ut=null,et=!1}}}function s(){let L=!1,et=null,K=null,mt=null,ut=null,ft=null,Pt=null,qt=null,ct=null;return{setTest:function(Nt){L||(Nt?rt(n.STENCIL_TEST):Ct(n.STENCIL_TEST))},setMask:function(Nt){et!==Nt&&!L&&(n.stencilMask(Nt),et=Nt)},setFunc:function(Nt,Xt,bt){(K!==Nt||mt!==Xt||ut!==bt)&&(n.stencilFunc(Nt,Xt,bt),K=Nt,mt=Xt,ut=bt)},setOp:function(Nt,Xt,bt){(ft!==Nt||Pt!==Xt||qt!==bt)&&(n.stencilOp(Nt,Xt,bt),ft=Nt,Pt=Xt,qt=bt)},setLocked:function(Nt){L=Nt},setClear:function(Nt){ct!==Nt&&(n.clearStencil(Nt),ct=Nt)},reset:function(){L=!1,et=null,K=null,mt=null,ut=null,ft=null,Pt=null,qt=null,ct=null}}}let r=new e,o=new i,a=new s,c={},l=new WeakMap,h={},d={},u={},p=new WeakMap,f=[],_=null,g=!1,m=null,y=null,E=null,b=null,T=null,w=null,x=null,M=new kt(0,0,0),D=0,P=!1,O=null,B=null,q=null,I=null,V=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,st=0,F=n.getParameter(n.VERSION);F.indexOf("WebGL")!==-1?(st=parseFloat(/^WebGL (\d)/.exec(F)[1]),W=st>=1):F.indexOf("OpenGL ES")!==-1&&(st=parseFloat(/^OpenGL ES (\d)/.exec(F)[1]),W=st>=2);let X=null,j={},ot=n.getParameter(n.SCISSOR_BOX),$=n.getParameter(n.VIEWPORT),R=new ue().fromArray(ot),z=new ue().fromArray($);function it(L,et,K,mt){let ut=new Uint8Array(4),ft=n.createTexture();n.bindTexture(L,ft),n.texParameteri(L,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(L,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Pt=0;Pt<K;Pt++)L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY?n.texImage3D(et,0,n.RGBA,1,1,mt,0,n.RGBA,n.UNSIGNED_BYTE,ut):n.texImage2D(et+Pt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ut);return ft}let ht={};ht[n.TEXTURE_2D]=it(n.TEXTURE_2D,n.TEXTURE_2D,1),ht[n.TEXTURE_CUBE_MAP]=it(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ht[n.TEXTURE_2D_ARRAY]=it(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ht[n.TEXTURE_3D]=it(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),rt(n.DEPTH_TEST),o.setFunc(Es),en(!1),J(kl),rt(n.CULL_FACE),Re(Ki);function rt(L){h[L]!==!0&&(n.enable(L),h[L]=!0)}function Ct(L){h[L]!==!1&&(n.disable(L),h[L]=!1)}function re(L,et){return u[L]!==et?(n.bindFramebuffer(L,et),u[L]=et,L===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=et),L===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=et),!0):!1}function It(L,et){let K=f,mt=!1;if(L){K=p.get(et),K===void 0&&(K=[],p.set(et,K));let ut=L.textures;if(K.length!==ut.length||K[0]!==n.COLOR_ATTACHMENT0){for(let ft=0,Pt=ut.length;ft<Pt;ft++)K[ft]=n.COLOR_ATTACHMENT0+ft;K.length=ut.length,mt=!0}}else K[0]!==n.BACK&&(K[0]=n.BACK,mt=!0);mt&&n.drawBuffers(K)}function Kt(L){return _!==L?(n.useProgram(L),_=L,!0):!1}let oe={[ji]:n.FUNC_ADD,[$d]:n.FUNC_SUBTRACT,[Yd]:n.FUNC_REVERSE_SUBTRACT};oe[Zd]=n.MIN,oe[Jd]=n.MAX;let Zt={[Kd]:n.ZERO,[jd]:n.ONE,[Qd]:n.SRC_COLOR,[Wl]:n.SRC_ALPHA,[of]:n.SRC_ALPHA_SATURATE,[sf]:n.DST_COLOR,[ef]:n.DST_ALPHA,[tf]:n.ONE_MINUS_SRC_COLOR,[Xl]:n.ONE_MINUS_SRC_ALPHA,[rf]:n.ONE_MINUS_DST_COLOR,[nf]:n.ONE_MINUS_DST_ALPHA,[af]:n.CONSTANT_COLOR,[cf]:n.ONE_MINUS_CONSTANT_COLOR,[lf]:n.CONSTANT_ALPHA,[hf]:n.ONE_MINUS_CONSTANT_ALPHA};function Re(L,et,K,mt,ut,ft,Pt,qt,ct,Nt){if(L===Ki){g===!0&&(Ct(n.BLEND),g=!1);return}if(g===!1&&(rt(n.BLEND),g=!0),L!==qd){if(L!==m||Nt!==P){if((y!==ji||T!==ji)&&(n.blendEquation(n.FUNC_ADD),y=ji,T=ji),Nt)switch(L){case Us:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gl:n.blendFunc(n.ONE,n.ONE);break;case Vl:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Hl:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Bt("WebGLState: Invalid blending: ",L);break}else switch(L){case Us:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gl:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Vl:Bt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Hl:Bt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Bt("WebGLState: Invalid blending: ",L);break}E=null,b=null,w=null,x=null,M.set(0,0,0),D=0,m=L,P=Nt}return}ut=ut||et,ft=ft||K,Pt=Pt||mt,(et!==y||ut!==T)&&(n.blendEquationSeparate(oe[et],oe[ut]),y=et,T=ut),(K!==E||mt!==b||ft!==w||Pt!==x)&&(n.blendFuncSeparate(Zt[K],Zt[mt],Zt[ft],Zt[Pt]),E=K,b=mt,w=ft,x=Pt),(qt.equals(M)===!1||ct!==D)&&(n.blendColor(qt.r,qt.g,qt.b,ct),M.copy(qt),D=ct),m=L,P=!1}function Ee(L,et){L.side===ke?Ct(n.CULL_FACE):rt(n.CULL_FACE);let K=L.side===hn;et&&(K=!K),en(K),L.blending===Us&&L.transparent===!1?Re(Ki):Re(L.blending,L.blendEquation,L.blendSrc,L.blendDst,L.blendEquationAlpha,L.blendSrcAlpha,L.blendDstAlpha,L.blendColor,L.blendAlpha,L.premultipliedAlpha),o.setFunc(L.depthFunc),o.setTest(L.depthTest),o.setMask(L.depthWrite),r.setMask(L.colorWrite);let mt=L.stencilWrite;a.setTest(mt),mt&&(a.setMask(L.stencilWriteMask),a.setFunc(L.stencilFunc,L.stencilRef,L.stencilFuncMask),a.setOp(L.stencilFail,L.stencilZFail,L.stencilZPass)),lt(L.polygonOffset,L.polygonOffsetFactor,L.polygonOffsetUnits),L.alphaToCoverage===!0?rt(n.SAMPLE_ALPHA_TO_COVERAGE):Ct(n.SAMPLE_ALPHA_TO_COVERAGE)}function en(L){O!==L&&(L?n.frontFace(n.CW):n.frontFace(n.CCW),O=L)}function J(L){L!==Hd?(rt(n.CULL_FACE),L!==B&&(L===kl?n.cullFace(n.BACK):L===Wd?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ct(n.CULL_FACE),B=L}function vt(L){L!==q&&(W&&n.lineWidth(L),q=L)}function lt(L,et,K){L?(rt(n.POLYGON_OFFSET_FILL),(I!==et||V!==K)&&(I=et,V=K,o.getReversed()&&(et=-et,K=-K),n.polygonOffset(et,K))):Ct(n.POLYGON_OFFSET_FILL)}function Lt(L){L?rt(n.SCISSOR_TEST):Ct(n.SCISSOR_TEST)}function Yt(L){L===void 0&&(L=n.TEXTURE0+Y-1),X!==L&&(n.activeTexture(L),X=L)}function be(L,et,K){K===void 0&&(X===null?K=n.TEXTURE0+Y-1:K=X);let mt=j[K];mt===void 0&&(mt={type:void 0,texture:void 0},j[K]=mt),(mt.type!==L||mt.texture!==et)&&(X!==K&&(n.activeTexture(K),X=K),n.bindTexture(L,et||ht[L]),mt.type=L,mt.texture=et)}function U(){let L=j[X];L!==void 0&&L.type!==void 0&&(n.bindTexture(L.type,null),L.type=void 0,L.texture=void 0)}function nn(){try{n.compressedTexImage2D(...arguments)}catch(L){Bt("WebGLState:",L)}}function de(){try{n.compressedTexImage3D(...arguments)}catch(L){Bt("WebGLState:",L)}}function xe(){try{n.texSubImage2D(...arguments)}catch(L){Bt("WebGLState:",L)}}function St(){try{n.texSubImage3D(...arguments)}catch(L){Bt("WebGLState:",L)}}function Pe(){try{n.compressedTexSubImage2D(...arguments)}catch(L){Bt("WebGLState:",L)}}function Ft(){try{n.compressedTexSubImage3D(...arguments)}catch(L){Bt("WebGLState:",L)}}function Gt(){try{n.texStorage2D(...arguments)}catch(L){Bt("WebGLState:",L)}}function A(){try{n.texStorage3D(...arguments)}catch(L){Bt("WebGLState:",L)}}function v(){try{n.texImage2D(...arguments)}catch(L){Bt("WebGLState:",L)}}function G(){try{n.texImage3D(...arguments)}catch(L){Bt("WebGLState:",L)}}function at(L){return d[L]!==void 0?d[L]:n.getParameter(L)}function nt(L,et){d[L]!==et&&(n.pixelStorei(L,et),d[L]=et)}function dt(L){R.equals(L)===!1&&(n.scissor(L.x,L.y,L.z,L.w),R.copy(L))}function _t(L){z.equals(L)===!1&&(n.viewport(L.x,L.y,L.z,L.w),z.copy(L))}function Q(L,et){let K=l.get(et);K===void 0&&(K=new WeakMap,l.set(et,K));let mt=K.get(L);mt===void 0&&(mt=n.getUniformBlockIndex(et,L.name),n.uniformBlockBinding(et,mt,mt),K.set(L,mt))}function tt(L,et,K){let ut=l.get(et).get(L);c[ut]!==K&&(n.bindBufferBase(n.UNIFORM_BUFFER,ut,K),c[ut]=K)}function pt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},d={},X=null,j={},u={},c={},p=new WeakMap,f=[],_=null,g=!1,m=null,y=null,E=null,b=null,T=null,w=null,x=null,M=new kt(0,0,0),D=0,P=!1,O=null,B=null,q=null,I=null,V=null,R.set(0,0,n.canvas.width,n.canvas.height),z.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:rt,disable:Ct,bindFramebuffer:re,drawBuffers:It,useProgram:Kt,setBlending:Re,setMaterial:Ee,setFlipSided:en,setCullFace:J,setLineWidth:vt,setPolygonOffset:lt,setScissorTest:Lt,activeTexture:Yt,bindTexture:be,unbindTexture:U,compressedTexImage2D:nn,compressedTexImage3D:de,texImage2D:v,texImage3D:G,pixelStorei:nt,getParameter:at,updateUBOMapping:Q,uniformBlockBinding:tt,texStorage2D:Gt,texStorage3D:A,texSubImage2D:xe,texSubImage3D:St,compressedTexSubImage2D:Pe,compressedTexSubImage3D:Ft,scissor:dt,viewport:_t,reset:pt}}function vb(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Ut,h=new WeakMap,d=new Set,u,p=new WeakMap,f=new Set,_=new FinalizationRegistry(A=>f.delete(A)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(A,v){return g?new OffscreenCanvas(A,v):pr("canvas")}function y(A,v,G){let at=1,nt=Gt(A);if((nt.width>G||nt.height>G)&&(at=G/Math.max(nt.width,nt.height)),at<1)if(typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&A instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&A instanceof ImageBitmap||typeof VideoFrame<"u"&&A instanceof VideoFrame){let dt=Math.floor(at*nt.width),_t=Math.floor(at*nt.height);u===void 0&&(u=m(dt,_t));let Q=v?m(dt,_t):u;return Q.width=dt,Q.height=_t,Q.getContext("2d").drawImage(A,0,0,dt,_t),Ot("WebGLRenderer: Texture has been resized from ("+nt.width+"x"+nt.height+") to ("+dt+"x"+_t+")."),Q}else return"data"in A&&Ot("WebGLRenderer: Image in DataTexture is too big ("+nt.width+"x"+nt.height+")."),A;return A}function E(A){return A.generateMipmaps}function b(A){n.generateMipmap(A)}function T(A){return A.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:A.isWebGL3DRenderTarget?n.TEXTURE_3D:A.isWebGLArrayRenderTarget||A.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function w(A,v,G,at,nt,dt=!1){if(A!==null){if(n[A]!==void 0)return n[A];Ot("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+A+"'")}let _t;at&&(_t=t.get("EXT_texture_norm16"),_t||Ot("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Q=v;if(v===n.RED&&(G===n.FLOAT&&(Q=n.R32F),G===n.HALF_FLOAT&&(Q=n.R16F),G===n.UNSIGNED_BYTE&&(Q=n.R8),G===n.UNSIGNED_SHORT&&_t&&(Q=_t.R16_EXT),G===n.SHORT&&_t&&(Q=_t.R16_SNORM_EXT)),v===n.RED_INTEGER&&(G===n.UNSIGNED_BYTE&&(Q=n.R8UI),G===n.UNSIGNED_SHORT&&(Q=n.R16UI),G===n.UNSIGNED_INT&&(Q=n.R32UI),G===n.BYTE&&(Q=n.R8I),G===n.SHORT&&(Q=n.R16I),G===n.INT&&(Q=n.R32I)),v===n.RG&&(G===n.FLOAT&&(Q=n.RG32F),G===n.HALF_FLOAT&&(Q=n.RG16F),G===n.UNSIGNED_BYTE&&(Q=n.RG8),G===n.UNSIGNED_SHORT&&_t&&(Q=_t.RG16_EXT),G===n.SHORT&&_t&&(Q=_t.RG16_SNORM_EXT)),v===n.RG_INTEGER&&(G===n.UNSIGNED_BYTE&&(Q=n.RG8UI),G===n.UNSIGNED_SHORT&&(Q=n.RG16UI),G===n.UNSIGNED_INT&&(Q=n.RG32UI),G===n.BYTE&&(Q=n.RG8I),G===n.SHORT&&(Q=n.RG16I),G===n.INT&&(Q=n.RG32I)),v===n.RGB_INTEGER&&(G===n.UNSIGNED_BYTE&&(Q=n.RGB8UI),G===n.UNSIGNED_SHORT&&(Q=n.RGB16UI),G===n.UNSIGNED_INT&&(Q=n.RGB32UI),G===n.BYTE&&(Q=n.RGB8I),G===n.SHORT&&(Q=n.RGB16I),G===n.INT&&(Q=n.RGB32I)),v===n.RGBA_INTEGER&&(G===n.UNSIGNED_BYTE&&(Q=n.RGBA8UI),G===n.UNSIGNED_SHORT&&(Q=n.RGBA16UI),G===n.UNSIGNED_INT&&(Q=n.RGBA32UI),G===n.BYTE&&(Q=n.RGBA8I),G===n.SHORT&&(Q=n.RGBA16I),G===n.INT&&(Q=n.RGBA32I)),v===n.RGB&&(G===n.UNSIGNED_SHORT&&_t&&(Q=_t.RGB16_EXT),G===n.SHORT&&_t&&(Q=_t.RGB16_SNORM_EXT),G===n.UNSIGNED_INT_5_9_9_9_REV&&(Q=n.RGB9_E5),G===n.UNSIGNED_INT_10F_11F_11F_REV&&(Q=n.R11F_G11F_B10F)),v===n.RGBA){let tt=dt?fr:te.getTransfer(nt);G===n.FLOAT&&(Q=n.RGBA32F),G===n.HALF_FLOAT&&(Q=n.RGBA16F),G===n.UNSIGNED_BYTE&&(Q=tt===le?n.SRGB8_ALPHA8:n.RGBA8),G===n.UNSIGNED_SHORT&&_t&&(Q=_t.RGBA16_EXT),G===n.SHORT&&_t&&(Q=_t.RGBA16_SNORM_EXT),G===n.UNSIGNED_SHORT_4_4_4_4&&(Q=n.RGBA4),G===n.UNSIGNED_SHORT_5_5_5_1&&(Q=n.RGB5_A1)}return(Q===n.R16F||Q===n.R32F||Q===n.RG16F||Q===n.RG32F||Q===n.RGBA16F||Q===n.RGBA32F)&&t.get("EXT_color_buffer_float"),Q}function x(A,v){let G;return A?v===null||v===kn||v===ts?G=n.DEPTH24_STENCIL8:v===Rn?G=n.DEPTH32F_STENCIL8:v===Bs&&(G=n.DEPTH24_STENCIL8,Ot("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===kn||v===ts?G=n.DEPTH_COMPONENT24:v===Rn?G=n.DEPTH_COMPONENT32F:v===Bs&&(G=n.DEPTH_COMPONENT16),G}function M(A,v){return E(A)===!0||A.isFramebufferTexture&&A.minFilter!==Be&&A.minFilter!==cn?Math.log2(Math.max(v.width,v.height))+1:A.mipmaps.length>0?A.mipmaps.length:A.isCompressedTexture&&Array.isArray(A.image)?v.mipmaps.length:1}function D(A){let v=new WeakRef(A);i.get(A).__ref=v,f.add(v),_.register(A,v,v)}function P(A){let v=i.get(A).__ref;v!==void 0&&(f.delete(v),_.unregister(v))}function O(A){q(A.target)}function B(A){I(A.target)}function q(A){A.removeEventListener("dispose",O),P(A),Y(A),A.isVideoTexture&&h.delete(A),A.isHTMLTexture&&d.delete(A)}function I(A){A.removeEventListener("dispose",B),P(A),st(A)}function V(){for(let A of f){let v=A.deref();v!==void 0&&(v.isRenderTarget===!0?I(v):q(v))}f.clear(),d.clear()}function Y(A){let v=i.get(A);if(v.__webglInit===void 0)return;let G=A.source,at=p.get(G);if(at){let nt=at[v.__cacheKey];nt.usedTimes--,nt.usedTimes===0&&W(A),Object.keys(at).length===0&&p.delete(G)}i.remove(A)}function W(A){let v=i.get(A);n.deleteTexture(v.__webglTexture);let G=A.source,at=p.get(G);delete at[v.__cacheKey],o.memory.textures--}function st(A){let v=i.get(A);v.__depthDisposeCallback&&v.__depthDisposeCallback();let G=A.depthTexture;if(G&&G.renderTarget===A&&q(G),A.isWebGLCubeRenderTarget)for(let nt=0;nt<6;nt++){if(Array.isArray(v.__webglFramebuffer[nt]))for(let dt=0;dt<v.__webglFramebuffer[nt].length;dt++)n.deleteFramebuffer(v.__webglFramebuffer[nt][dt]);else n.deleteFramebuffer(v.__webglFramebuffer[nt]);v.__webglDepthbuffer&&n.deleteRenderbuffer(v.__webglDepthbuffer[nt])}else{if(Array.isArray(v.__webglFramebuffer))for(let nt=0;nt<v.__webglFramebuffer.length;nt++)n.deleteFramebuffer(v.__webglFramebuffer[nt]);else n.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&n.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&n.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let nt=0;nt<v.__webglColorRenderbuffer.length;nt++)v.__webglColorRenderbuffer[nt]&&n.deleteRenderbuffer(v.__webglColorRenderbuffer[nt]);v.__webglDepthRenderbuffer&&n.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let at=A.textures;for(let nt=0,dt=at.length;nt<dt;nt++){let _t=i.get(at[nt]);_t.__webglTexture&&(n.deleteTexture(_t.__webglTexture),o.memory.textures--),i.remove(at[nt])}i.remove(A)}let F=0;function X(){F=0}function j(){return F}function ot(A){F=A}function $(){let A=F;return A>=s.maxTextures&&Ot("WebGLTextures: Trying to use "+(A+1)+" texture units while this GPU supports only "+s.maxTextures),F+=1,A}function R(A){let v=[];return v.push(A.wrapS),v.push(A.wrapT),v.push(A.wrapR||0),v.push(A.magFilter),v.push(A.minFilter),v.push(A.anisotropy),v.push(A.internalFormat),v.push(A.format),v.push(A.type),v.push(A.generateMipmaps),v.push(A.mipmapsAutoUpdate),v.push(A.premultiplyAlpha),v.push(A.flipY),v.push(A.unpackAlignment),v.push(A.colorSpace),v.join()}function z(A,v){let G=i.get(A);if(A.isVideoTexture&&Pe(A),A.isRenderTargetTexture===!1&&A.isExternalTexture!==!0&&A.version>0&&G.__version!==A.version){let at=A.image;if(at===null)Ot("WebGLRenderer: Texture marked for update but no image data found.");else if(at.complete===!1)Ot("WebGLRenderer: Texture marked for update but image is incomplete");else{Ee(G,A,v);return}}else A.isExternalTexture&&(G.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,G.__webglTexture,n.TEXTURE0+v)}function it(A,v){let G=i.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&G.__version!==A.version){Ee(G,A,v);return}else A.isExternalTexture&&(G.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,G.__webglTexture,n.TEXTURE0+v)}function ht(A,v){let G=i.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&G.__version!==A.version){Ee(G,A,v);return}e.bindTexture(n.TEXTURE_3D,G.__webglTexture,n.TEXTURE0+v)}function rt(A,v){let G=i.get(A);if(A.version>0&&G.__version!==A.version){en(G,A,v);return}e.bindTexture(n.TEXTURE_CUBE_MAP,G.__webglTexture,n.TEXTURE0+v)}let Ct={[Ko]:n.REPEAT,[qn]:n.CLAMP_TO_EDGE,[jo]:n.MIRRORED_REPEAT},re={[Be]:n.NEAREST,[ff]:n.NEAREST_MIPMAP_NEAREST,[zr]:n.NEAREST_MIPMAP_LINEAR,[cn]:n.LINEAR,[Ta]:n.LINEAR_MIPMAP_NEAREST,[pi]:n.LINEAR_MIPMAP_LINEAR},It={[_f]:n.NEVER,[ch]:n.ALWAYS,[xf]:n.LESS,[oh]:n.LEQUAL,[yf]:n.EQUAL,[ah]:n.GEQUAL,[vf]:n.GREATER,[Sf]:n.NOTEQUAL};function Kt(A,v){if(v.type===Rn&&t.has("OES_texture_float_linear")===!1&&(v.magFilter===cn||v.magFilter===Ta||v.magFilter===zr||v.magFilter===pi||v.minFilter===cn||v.minFilter===Ta||v.minFilter===zr||v.minFilter===pi)&&Ot("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(A,n.TEXTURE_WRAP_S,Ct[v.wrapS]),n.texParameteri(A,n.TEXTURE_WRAP_T,Ct[v.wrapT]),(A===n.TEXTURE_3D||A===n.TEXTURE_2D_ARRAY)&&n.texParameteri(A,n.TEXTURE_WRAP_R,Ct[v.wrapR]),n.texParameteri(A,n.TEXTURE_MAG_FILTER,re[v.magFilter]),n.texParameteri(A,n.TEXTURE_MIN_FILTER,re[v.minFilter]),v.compareFunction&&(n.texParameteri(A,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(A,n.TEXTURE_COMPARE_FUNC,It[v.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===Be||v.minFilter!==zr&&v.minFilter!==pi||v.type===Rn&&t.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||i.get(v).__currentAnisotropy){let G=t.get("EXT_texture_filter_anisotropic");n.texParameterf(A,G.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),i.get(v).__currentAnisotropy=v.anisotropy}}}function oe(A,v){let G=!1;A.__webglInit===void 0&&(A.__webglInit=!0,v.addEventListener("dispose",O),D(v));let at=v.source,nt=p.get(at);nt===void 0&&(nt={},p.set(at,nt));let dt=R(v);if(dt!==A.__cacheKey){nt[dt]===void 0&&(nt[dt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,G=!0),nt[dt].usedTimes++;let _t=nt[A.__cacheKey];_t!==void 0&&(nt[A.__cacheKey].usedTimes--,_t.usedTimes===0&&W(v)),A.__cacheKey=dt,A.__webglTexture=nt[dt].texture}return G}function Zt(A,v,G){return Math.floor(Math.floor(A/G)/v)}function Re(A,v,G,at){let dt=A.updateRanges;if(dt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,v.width,v.height,G,at,v.data);else{dt.sort((L,et)=>L.start-et.start);let _t=0;for(let L=1;L<dt.length;L++){let et=dt[_t],K=dt[L],mt=et.start+et.count,ut=Zt(K.start,v.width,4),ft=Zt(et.start,v.width,4);K.start<=mt+1&&ut===ft&&Zt(K.start+K.count-1,v.width,4)===ut?et.count=Math.max(et.count,K.start+K.count-et.start):(++_t,dt[_t]=K)}dt.length=_t+1;let Q=e.getParameter(n.UNPACK_ROW_LENGTH),tt=e.getParameter(n.UNPACK_SKIP_PIXELS),pt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,v.width);for(let L=0,et=dt.length;L<et;L++){let K=dt[L],mt=Math.floor(K.start/4),ut=Math.ceil(K.count/4),ft=mt%v.width,Pt=Math.floor(mt/v.width),qt=ut,ct=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,ft),e.pixelStorei(n.UNPACK_SKIP_ROWS,Pt),e.texSubImage2D(n.TEXTURE_2D,0,ft,Pt,qt,ct,G,at,v.data)}A.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,Q),e.pixelStorei(n.UNPACK_SKIP_PIXELS,tt),e.pixelStorei(n.UNPACK_SKIP_ROWS,pt)}}function Ee(A,v,G){let at=n.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(at=n.TEXTURE_2D_ARRAY),v.isData3DTexture&&(at=n.TEXTURE_3D);let nt=oe(A,v),dt=v.source;e.bindTexture(at,A.__webglTexture,n.TEXTURE0+G);let _t=i.get(dt);if(dt.version!==_t.__version||nt===!0){if(e.activeTexture(n.TEXTURE0+G),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let ct=te.getPrimaries(te.workingColorSpace),Nt=v.colorSpace===gi?null:te.getPrimaries(v.colorSpace),Xt=v.colorSpace===gi||ct===Nt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Xt)}e.pixelStorei(n.UNPACK_ALIGNMENT,v.unpackAlignment);let tt=y(v.image,!1,s.maxTextureSize);tt=Ft(v,tt);let pt=r.convert(v.format,v.colorSpace),L=r.convert(v.type),et=w(v.internalFormat,pt,L,v.normalized,v.colorSpace,v.isVideoTexture);Kt(at,v);let K,mt=v.mipmaps,ut=v.isVideoTexture!==!0,ft=_t.__version===void 0||nt===!0,Pt=dt.dataReady,qt=M(v,tt);if(v.isDepthTexture)et=x(v.format===mi,v.type),ft&&(ut?e.texStorage2D(n.TEXTURE_2D,1,et,tt.width,tt.height):e.texImage2D(n.TEXTURE_2D,0,et,tt.width,tt.height,0,pt,L,null));else if(v.isDataTexture)if(mt.length>0){ut&&ft&&e.texStorage2D(n.TEXTURE_2D,qt,et,mt[0].width,mt[0].height);for(let ct=0,Nt=mt.length;ct<Nt;ct++)K=mt[ct],ut?Pt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,K.width,K.height,pt,L,K.data):e.texImage2D(n.TEXTURE_2D,ct,et,K.width,K.height,0,pt,L,K.data);v.generateMipmaps=!1}else ut?(ft&&e.texStorage2D(n.TEXTURE_2D,qt,et,tt.width,tt.height),Pt&&Re(v,tt,pt,L)):e.texImage2D(n.TEXTURE_2D,0,et,tt.width,tt.height,0,pt,L,tt.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){ut&&ft&&e.texStorage3D(n.TEXTURE_2D_ARRAY,qt,et,mt[0].width,mt[0].height,tt.depth);for(let ct=0,Nt=mt.length;ct<Nt;ct++)if(K=mt[ct],v.format!==Vn)if(pt!==null)if(ut){if(Pt)if(v.layerUpdates.size>0){let Xt=xh(K.width,K.height,v.format,v.type);for(let bt of v.layerUpdates){let fe=K.data.subarray(bt*Xt/K.data.BYTES_PER_ELEMENT,(bt+1)*Xt/K.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,bt,K.width,K.height,1,pt,fe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,K.width,K.height,tt.depth,pt,K.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ct,et,K.width,K.height,tt.depth,0,K.data,0,0);else Ot("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ut?Pt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,K.width,K.height,tt.depth,pt,L,K.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ct,et,K.width,K.height,tt.depth,0,pt,L,K.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{ut&&ft&&e.texStorage2D(n.TEXTURE_2D,qt,et,mt[0].width,mt[0].height);for(let ct=0,Nt=mt.length;ct<Nt;ct++)K=mt[ct],v.format!==Vn?pt!==null?ut?Pt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ct,0,0,K.width,K.height,pt,K.data):e.compressedTexImage2D(n.TEXTURE_2D,ct,et,K.width,K.height,0,K.data):Ot("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ut?Pt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,K.width,K.height,pt,L,K.data):e.texImage2D(n.TEXTURE_2D,ct,et,K.width,K.height,0,pt,L,K.data)}else if(v.isDataArrayTexture)if(ut){if(ft&&e.texStorage3D(n.TEXTURE_2D_ARRAY,qt,et,tt.width,tt.height,tt.depth),Pt)if(v.layerUpdates.size>0){let ct=xh(tt.width,tt.height,v.format,v.type);for(let Nt of v.layerUpdates){let Xt=tt.data.subarray(Nt*ct/tt.data.BYTES_PER_ELEMENT,(Nt+1)*ct/tt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Nt,tt.width,tt.height,1,pt,L,Xt)}v.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,tt.width,tt.height,tt.depth,pt,L,tt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,et,tt.width,tt.height,tt.depth,0,pt,L,tt.data);else if(v.isData3DTexture)ut?(ft&&e.texStorage3D(n.TEXTURE_3D,qt,et,tt.width,tt.height,tt.depth),Pt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,tt.width,tt.height,tt.depth,pt,L,tt.data)):e.texImage3D(n.TEXTURE_3D,0,et,tt.width,tt.height,tt.depth,0,pt,L,tt.data);else if(v.isFramebufferTexture){if(ft)if(ut)e.texStorage2D(n.TEXTURE_2D,qt,et,tt.width,tt.height);else{let ct=tt.width,Nt=tt.height;for(let Xt=0;Xt<qt;Xt++)e.texImage2D(n.TEXTURE_2D,Xt,et,ct,Nt,0,pt,L,null),ct>>=1,Nt>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in n){let ct=n.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),tt.parentNode!==ct){ct.appendChild(tt),d.add(v),ct.onpaint=Nt=>{let Xt=Nt.changedElements;for(let bt of d)Xt.includes(bt.image)&&(bt.needsUpdate=!0)},ct.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,tt);else{let Xt=n.RGBA,bt=n.RGBA,fe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Xt,bt,fe,tt)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(mt.length>0){if(ut&&ft){let ct=Gt(mt[0]);e.texStorage2D(n.TEXTURE_2D,qt,et,ct.width,ct.height)}for(let ct=0,Nt=mt.length;ct<Nt;ct++)K=mt[ct],ut?Pt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,pt,L,K):e.texImage2D(n.TEXTURE_2D,ct,et,pt,L,K);v.generateMipmaps=!1}else if(ut){if(ft){let ct=Gt(tt);e.texStorage2D(n.TEXTURE_2D,qt,et,ct.width,ct.height)}Pt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,pt,L,tt)}else e.texImage2D(n.TEXTURE_2D,0,et,pt,L,tt);E(v)&&v.mipmapsAutoUpdate===!0&&b(at),_t.__version=dt.version,v.onUpdate&&v.onUpdate(v)}A.__version=v.version}function en(A,v,G){if(v.image.length!==6)return;let at=oe(A,v),nt=v.source;e.bindTexture(n.TEXTURE_CUBE_MAP,A.__webglTexture,n.TEXTURE0+G);let dt=i.get(nt);if(nt.version!==dt.__version||at===!0){e.activeTexture(n.TEXTURE0+G);let _t=te.getPrimaries(te.workingColorSpace),Q=v.colorSpace===gi?null:te.getPrimaries(v.colorSpace),tt=v.colorSpace===gi||_t===Q?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,v.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt);let pt=v.isCompressedTexture||v.image[0].isCompressedTexture,L=v.image[0]&&v.image[0].isDataTexture,et=[];for(let bt=0;bt<6;bt++)!pt&&!L?et[bt]=y(v.image[bt],!0,s.maxCubemapSize):et[bt]=L?v.image[bt].image:v.image[bt],et[bt]=Ft(v,et[bt]);let K=et[0],mt=r.convert(v.format,v.colorSpace),ut=r.convert(v.type),ft=w(v.internalFormat,mt,ut,v.normalized,v.colorSpace),Pt=v.isVideoTexture!==!0,qt=dt.__version===void 0||at===!0,ct=nt.dataReady,Nt=M(v,K);Kt(n.TEXTURE_CUBE_MAP,v);let Xt;if(v.isDepthTexture){if(ft=x(v.format===mi,v.type),qt)if(Pt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,ft,K.width,K.height);else for(let bt=0;bt<6;bt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,0,ft,K.width,K.height,0,mt,ut,null)}else if(pt){Pt&&qt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Nt,ft,K.width,K.height);for(let bt=0;bt<6;bt++){Xt=et[bt].mipmaps;for(let fe=0;fe<Xt.length;fe++){let Oe=Xt[fe];v.format!==Vn?mt!==null?Pt?ct&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,fe,0,0,Oe.width,Oe.height,mt,Oe.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,fe,ft,Oe.width,Oe.height,0,Oe.data):Ot("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Pt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,fe,0,0,Oe.width,Oe.height,mt,ut,Oe.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,fe,ft,Oe.width,Oe.height,0,mt,ut,Oe.data)}}}else{if(Xt=v.mipmaps,Pt&&qt){Xt.length>0&&Nt++;let bt=Gt(et[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Nt,ft,bt.width,bt.height)}for(let bt=0;bt<6;bt++)if(L){Pt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,0,0,0,et[bt].width,et[bt].height,mt,ut,et[bt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,0,ft,et[bt].width,et[bt].height,0,mt,ut,et[bt].data);for(let fe=0;fe<Xt.length;fe++){let xi=Xt[fe].image[bt].image;Pt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,fe+1,0,0,xi.width,xi.height,mt,ut,xi.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,fe+1,ft,xi.width,xi.height,0,mt,ut,xi.data)}}else{Pt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,0,0,0,mt,ut,et[bt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,0,ft,mt,ut,et[bt]);for(let fe=0;fe<Xt.length;fe++){let Oe=Xt[fe];Pt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,fe+1,0,0,mt,ut,Oe.image[bt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,fe+1,ft,mt,ut,Oe.image[bt])}}}E(v)&&v.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),dt.__version=nt.version,v.onUpdate&&v.onUpdate(v)}A.__version=v.version}function J(A,v,G,at,nt,dt){let _t=r.convert(G.format,G.colorSpace),Q=r.convert(G.type),tt=w(G.internalFormat,_t,Q,G.normalized,G.colorSpace),pt=i.get(v),L=i.get(G);if(L.__renderTarget=v,!pt.__hasExternalTextures){let et=Math.max(1,v.width>>dt),K=Math.max(1,v.height>>dt);nt===n.TEXTURE_3D||nt===n.TEXTURE_2D_ARRAY?e.texImage3D(nt,dt,tt,et,K,v.depth,0,_t,Q,null):e.texImage2D(nt,dt,tt,et,K,0,_t,Q,null)}e.bindFramebuffer(n.FRAMEBUFFER,A),St(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,at,nt,L.__webglTexture,0,xe(v)):(nt===n.TEXTURE_2D||nt>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&nt<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,at,nt,L.__webglTexture,dt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function vt(A,v,G){if(n.bindRenderbuffer(n.RENDERBUFFER,A),v.depthBuffer){let at=v.depthTexture,nt=at&&at.isDepthTexture?at.type:null,dt=x(v.stencilBuffer,nt),_t=v.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;St(v)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,xe(v),dt,v.width,v.height):G?n.renderbufferStorageMultisample(n.RENDERBUFFER,xe(v),dt,v.width,v.height):n.renderbufferStorage(n.RENDERBUFFER,dt,v.width,v.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,_t,n.RENDERBUFFER,A)}else{let at=v.textures;for(let nt=0;nt<at.length;nt++){let dt=at[nt],_t=r.convert(dt.format,dt.colorSpace),Q=r.convert(dt.type),tt=w(dt.internalFormat,_t,Q,dt.normalized,dt.colorSpace);St(v)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,xe(v),tt,v.width,v.height):G?n.renderbufferStorageMultisample(n.RENDERBUFFER,xe(v),tt,v.width,v.height):n.renderbufferStorage(n.RENDERBUFFER,tt,v.width,v.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function lt(A,v,G){let at=v.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,A),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let nt=i.get(v.depthTexture);nt.__renderTarget=v;let dt=at?v.depthTexture.image[0]:v.depthTexture.image;(!nt.__webglTexture||dt.width!==v.width||dt.height!==v.height)&&(dt.width=v.width,dt.height=v.height,v.depthTexture.needsUpdate=!0),at?rt(v.depthTexture,0):z(v.depthTexture,0);let _t=nt.__webglTexture,Q=xe(v),tt=at?n.TEXTURE_CUBE_MAP_POSITIVE_X+G:n.TEXTURE_2D,pt=v.depthTexture.format===mi?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(v.depthTexture.format===hi)St(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,tt,_t,0,Q):n.framebufferTexture2D(n.FRAMEBUFFER,pt,tt,_t,0);else if(v.depthTexture.format===mi)St(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,tt,_t,0,Q):n.framebufferTexture2D(n.FRAMEBUFFER,pt,tt,_t,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Lt(A){let v=i.get(A),G=A.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==A.depthTexture){let at=A.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),at){let nt=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,at.removeEventListener("dispose",nt)};at.addEventListener("dispose",nt),v.__depthDisposeCallback=nt}v.__boundDepthTexture=at}if(A.depthTexture&&!v.__autoAllocateDepthBuffer)if(G)for(let at=0;at<6;at++)lt(v.__webglFramebuffer[at],A,at);else A.texture.mipmaps.length>0?lt(v.__webglFramebuffer[0],A,0):lt(v.__webglFramebuffer,A,0);else if(G){v.__webglDepthbuffer=[];for(let at=0;at<6;at++)if(e.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer[at]),v.__webglDepthbuffer[at]===void 0)v.__webglDepthbuffer[at]=n.createRenderbuffer(),vt(v.__webglDepthbuffer[at],A,!1);else{let nt=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,dt=v.__webglDepthbuffer[at];n.bindRenderbuffer(n.RENDERBUFFER,dt),n.framebufferRenderbuffer(n.FRAMEBUFFER,nt,n.RENDERBUFFER,dt)}}else if(A.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=n.createRenderbuffer(),vt(v.__webglDepthbuffer,A,!1);else{let nt=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,dt=v.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,dt),n.framebufferRenderbuffer(n.FRAMEBUFFER,nt,n.RENDERBUFFER,dt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Yt(A,v,G){let at=i.get(A);v!==void 0&&J(at.__webglFramebuffer,A,A.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),G!==void 0&&Lt(A)}function be(A){let v=A.texture,G=i.get(A),at=i.get(v);A.addEventListener("dispose",B),D(A);let nt=A.textures,dt=A.isWebGLCubeRenderTarget===!0,_t=nt.length>1;if(_t||(at.__webglTexture===void 0&&(at.__webglTexture=n.createTexture()),at.__version=v.version,o.memory.textures++),dt){G.__webglFramebuffer=[];for(let Q=0;Q<6;Q++)if(v.mipmaps.length>0){G.__webglFramebuffer[Q]=[];for(let tt=0;tt<v.mipmaps.length;tt++)G.__webglFramebuffer[Q][tt]=n.createFramebuffer()}else G.__webglFramebuffer[Q]=n.createFramebuffer()}else{if(v.mipmaps.length>0){G.__webglFramebuffer=[];for(let Q=0;Q<v.mipmaps.length;Q++)G.__webglFramebuffer[Q]=n.createFramebuffer()}else G.__webglFramebuffer=n.createFramebuffer();if(_t)for(let Q=0,tt=nt.length;Q<tt;Q++){let pt=i.get(nt[Q]);pt.__webglTexture===void 0&&(pt.__webglTexture=n.createTexture(),o.memory.textures++)}if(A.samples>0&&St(A)===!1){G.__webglMultisampledFramebuffer=n.createFramebuffer(),G.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,G.__webglMultisampledFramebuffer);for(let Q=0;Q<nt.length;Q++){let tt=nt[Q];G.__webglColorRenderbuffer[Q]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,G.__webglColorRenderbuffer[Q]);let pt=r.convert(tt.format,tt.colorSpace),L=r.convert(tt.type),et=w(tt.internalFormat,pt,L,tt.normalized,tt.colorSpace,A.isXRRenderTarget===!0),K=xe(A);n.renderbufferStorageMultisample(n.RENDERBUFFER,K,et,A.width,A.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Q,n.RENDERBUFFER,G.__webglColorRenderbuffer[Q])}n.bindRenderbuffer(n.RENDERBUFFER,null),A.depthBuffer&&(G.__webglDepthRenderbuffer=n.createRenderbuffer(),vt(G.__webglDepthRenderbuffer,A,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(dt){e.bindTexture(n.TEXTURE_CUBE_MAP,at.__webglTexture),Kt(n.TEXTURE_CUBE_MAP,v);for(let Q=0;Q<6;Q++)if(v.mipmaps.length>0)for(let tt=0;tt<v.mipmaps.length;tt++)J(G.__webglFramebuffer[Q][tt],A,v,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Q,tt);else J(G.__webglFramebuffer[Q],A,v,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Q,0);E(v)?b(n.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}else if(_t){for(let Q=0,tt=nt.length;Q<tt;Q++){let pt=nt[Q],L=i.get(pt),et=n.TEXTURE_2D;(A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(et=A.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(et,L.__webglTexture),Kt(et,pt),J(G.__webglFramebuffer,A,pt,n.COLOR_ATTACHMENT0+Q,et,0),E(pt)&&b(et)}e.unbindTexture()}else{let Q=n.TEXTURE_2D;if((A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(Q=A.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(Q,at.__webglTexture),Kt(Q,v),v.mipmaps.length>0)for(let tt=0;tt<v.mipmaps.length;tt++)J(G.__webglFramebuffer[tt],A,v,n.COLOR_ATTACHMENT0,Q,tt);else J(G.__webglFramebuffer,A,v,n.COLOR_ATTACHMENT0,Q,0);E(v)?b(Q):v.mipmaps.length>0&&n.texParameteri(Q,n.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}A.depthBuffer&&Lt(A)}function U(A){let v=A.textures;for(let G=0,at=v.length;G<at;G++){let nt=v[G];if(E(nt)&&nt.mipmapsAutoUpdate===!0){let dt=T(A),_t=i.get(nt).__webglTexture;e.bindTexture(dt,_t),b(dt),e.unbindTexture()}}}let nn=[];function de(A){if(A.samples>0){if(St(A)===!1){let v=A.textures,G=A.width,at=A.height,nt=n.COLOR_BUFFER_BIT,dt=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=i.get(A),Q=v.length>1;if(Q)for(let pt=0;pt<v.length;pt++)e.bindFramebuffer(n.FRAMEBUFFER,_t.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,_t.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,_t.__webglMultisampledFramebuffer),A.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,_t.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,_t.__webglFramebuffer);for(let pt=0;pt<v.length;pt++){if(A.resolveDepthBuffer&&(A.depthBuffer&&(nt|=n.DEPTH_BUFFER_BIT),A.stencilBuffer&&A.resolveStencilBuffer&&(nt|=n.STENCIL_BUFFER_BIT)),Q){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,_t.__webglColorRenderbuffer[pt]);let L=i.get(v[pt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,L,0)}n.blitFramebuffer(0,0,G,at,0,0,G,at,nt,n.NEAREST),c===!0&&(nn.length=0,nn.push(n.COLOR_ATTACHMENT0+pt),A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&nn.push(dt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,nn))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),Q)for(let pt=0;pt<v.length;pt++){e.bindFramebuffer(n.FRAMEBUFFER,_t.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,_t.__webglColorRenderbuffer[pt]);let L=i.get(v[pt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,_t.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,L,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,_t.__webglMultisampledFramebuffer)}else if(A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&c){let v=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[v])}}}function xe(A){return Math.min(s.maxSamples,A.samples)}function St(A){let v=i.get(A);return A.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function Pe(A){let v=o.render.frame;h.get(A)!==v&&(h.set(A,v),A.update())}function Ft(A,v){let G=A.colorSpace,at=A.format,nt=A.type;return A.isCompressedTexture===!0||A.isVideoTexture===!0||G!==dr&&G!==gi&&(te.getTransfer(G)===le?(at!==Vn||nt!==pn)&&Ot("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Bt("WebGLTextures: Unsupported texture color space:",G)),v}function Gt(A){return typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement?(l.width=A.naturalWidth||A.width,l.height=A.naturalHeight||A.height):typeof VideoFrame<"u"&&A instanceof VideoFrame?(l.width=A.displayWidth,l.height=A.displayHeight):(l.width=A.width,l.height=A.height),l}this.allocateTextureUnit=$,this.resetTextureUnits=X,this.getTextureUnits=j,this.setTextureUnits=ot,this.setTexture2D=z,this.setTexture2DArray=it,this.setTexture3D=ht,this.setTextureCube=rt,this.rebindTextures=Yt,this.setupRenderTarget=be,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=de,this.setupDepthRenderbuffer=Lt,this.setupFrameBufferTexture=J,this.useMultisampledRTT=St,this.dispose=V}function Sb(n,t){function e(i,s=gi){let r,o=te.getTransfer(s);if(i===pn)return n.UNSIGNED_BYTE;if(i===Ra)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Pa)return n.UNSIGNED_SHORT_5_5_5_1;if(i===nh)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===ih)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===th)return n.BYTE;if(i===eh)return n.SHORT;if(i===Bs)return n.UNSIGNED_SHORT;if(i===Ca)return n.INT;if(i===kn)return n.UNSIGNED_INT;if(i===Rn)return n.FLOAT;if(i===Gn)return n.HALF_FLOAT;if(i===sh)return n.ALPHA;if(i===rh)return n.RGB;if(i===Vn)return n.RGBA;if(i===hi)return n.DEPTH_COMPONENT;if(i===mi)return n.DEPTH_STENCIL;if(i===Ia)return n.RED;if(i===La)return n.RED_INTEGER;if(i===Oi)return n.RG;if(i===Da)return n.RG_INTEGER;if(i===Na)return n.RGBA_INTEGER;if(i===kr||i===Gr||i===Vr||i===Hr)if(o===le)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===kr)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Gr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Vr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Hr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===kr)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Gr)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Vr)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Hr)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Oa||i===Ua||i===Fa||i===Ba)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Oa)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Ua)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Fa)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Ba)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===za||i===ka||i===Ga||i===Va||i===Ha||i===Wr||i===Wa)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===za||i===ka)return o===le?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ga)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Va)return r.COMPRESSED_R11_EAC;if(i===Ha)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Wr)return r.COMPRESSED_RG11_EAC;if(i===Wa)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Xa||i===qa||i===$a||i===Ya||i===Za||i===Ja||i===Ka||i===ja||i===Qa||i===tc||i===ec||i===nc||i===ic||i===sc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Xa)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===qa)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===$a)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Ya)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Za)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ja)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ka)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===ja)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Qa)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===tc)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===ec)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===nc)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===ic)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===sc)return o===le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===rc||i===oc||i===ac)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===rc)return o===le?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===oc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===ac)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===cc||i===lc||i===Xr||i===hc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===cc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===lc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Xr)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===hc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ts?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var bb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Mb=`
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

}`,Lh=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Ar(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Cn({vertexShader:bb,fragmentShader:Mb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new ne(new fi(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Dh=class extends Fn{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,d=null,u=null,p=null,f=null,_=typeof XRWebGLBinding<"u",g=new Lh,m={},y=e.getContextAttributes(),E=null,b=null,T=[],w=[],x=new Ut,M=null,D=null,P=new an;P.viewport=new ue;let O=new an;O.viewport=new ue;let B=[P,O],q=new ba,I=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(R){let z=T[R];return z===void 0&&(z=new Is,T[R]=z),z.getTargetRaySpace()},this.getControllerGrip=function(R){let z=T[R];return z===void 0&&(z=new Is,T[R]=z),z.getGripSpace()},this.getHand=function(R){let z=T[R];return z===void 0&&(z=new Is,T[R]=z),z.getHandSpace()};function Y(R){let z=w.indexOf(R.inputSource);if(z===-1)return;let it=T[z];it!==void 0&&(it.update(R.inputSource,R.frame,l||o),it.dispatchEvent({type:R.type,data:R.inputSource}))}function W(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",st);for(let R=0;R<T.length;R++){let z=w[R];z!==null&&(w[R]=null,T[R].disconnect(z))}I=null,V=null,g.reset();for(let R in m)delete m[R];if(t.setRenderTarget(E),p=null,u=null,d=null,s=null,b=null,$.stop(),i.isPresenting=!1,t.setPixelRatio(M),t.setSize(x.width,x.height,!1),D!==null){let R=D.camera;R.fov=D.fov,R.zoom=D.zoom,R.updateProjectionMatrix(),D=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(R){r=R,i.isPresenting===!0&&Ot("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(R){a=R,i.isPresenting===!0&&Ot("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(R){l=R},this.getBaseLayer=function(){return u!==null?u:p},this.getBinding=function(){return d===null&&_&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return f},this.getSession=function(){return s},this.setSession=async function(R){if(s=R,s!==null){if(E=t.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",W),s.addEventListener("inputsourceschange",st),y.xrCompatible!==!0&&await e.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(x),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let it=null,ht=null,rt=null;y.depth&&(rt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,it=y.stencil?mi:hi,ht=y.stencil?ts:kn);let Ct={colorFormat:e.RGBA8,depthFormat:rt,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Ct),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),b=new xn(u.textureWidth,u.textureHeight,{format:Vn,type:pn,depthTexture:new di(u.textureWidth,u.textureHeight,ht,void 0,void 0,void 0,void 0,void 0,void 0,it),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let it={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,it),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),b=new xn(p.framebufferWidth,p.framebufferHeight,{format:Vn,type:pn,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),$.setContext(s),$.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function st(R){for(let z=0;z<R.removed.length;z++){let it=R.removed[z],ht=w.indexOf(it);ht>=0&&(w[ht]=null,T[ht].disconnect(it))}for(let z=0;z<R.added.length;z++){let it=R.added[z],ht=w.indexOf(it);if(ht===-1){for(let Ct=0;Ct<T.length;Ct++)if(Ct>=w.length){w.push(it),ht=Ct;break}else if(w[Ct]===null){w[Ct]=it,ht=Ct;break}if(ht===-1)break}let rt=T[ht];rt&&rt.connect(it)}}function F(R,z){z===null?R.matrixWorld.copy(R.matrix):R.matrixWorld.multiplyMatrices(z.matrixWorld,R.matrix),R.matrixWorldInverse.copy(R.matrixWorld).invert()}this.updateCamera=function(R){if(s===null)return;let z=R.near,it=R.far;g.texture!==null&&(g.depthNear>0&&(z=g.depthNear),g.depthFar>0&&(it=g.depthFar)),q.near=O.near=P.near=z,q.far=O.far=P.far=it,(I!==q.near||V!==q.far)&&(s.updateRenderState({depthNear:q.near,depthFar:q.far}),I=q.near,V=q.far),q.layers.mask=R.layers.mask|6,P.layers.mask=q.layers.mask&-5,O.layers.mask=q.layers.mask&-3;let ht=R.parent,rt=q.cameras;F(q,ht);for(let Ct=0;Ct<rt.length;Ct++)F(rt[Ct],ht);q.projectionMatrix.copy(P.projectionMatrix),q.projectionMatrixInverse.copy(P.projectionMatrixInverse),D===null&&R.isPerspectiveCamera&&(D={camera:R,fov:R.fov,zoom:R.zoom}),X(R,q,ht)};function X(R,z,it){it===null?R.matrix.copy(z.matrixWorld):(R.matrix.copy(it.matrixWorld),R.matrix.invert(),R.matrix.multiply(z.matrixWorld)),R.matrix.decompose(R.position,R.quaternion,R.scale),R.updateMatrixWorld(!0),R.projectionMatrix.copy(z.projectionMatrix),R.projectionMatrixInverse.copy(z.projectionMatrixInverse),R.isPerspectiveCamera&&(R.fov=Cs*2*Math.atan(1/R.projectionMatrix.elements[5]),R.zoom=1)}this.getCamera=function(){return q},this.getFoveation=function(){if(!(u===null&&p===null))return c},this.setFoveation=function(R){c=R,u!==null&&(u.fixedFoveation=R),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=R)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(q)},this.getCameraTexture=function(R){return m[R]};let j=null;function ot(R,z){if(h=z.getViewerPose(l||o),f=z,h!==null){let it=h.views;p!==null&&(t.setRenderTargetFramebuffer(b,p.framebuffer),t.setRenderTarget(b));let ht=!1;it.length!==q.cameras.length&&(q.cameras.length=0,ht=!0);for(let It=0;It<it.length;It++){let Kt=it[It],oe=null;if(p!==null)oe=p.getViewport(Kt);else{let Re=d.getViewSubImage(u,Kt);oe=Re.viewport,It===0&&(t.setRenderTargetTextures(b,Re.colorTexture,Re.depthStencilTexture),t.setRenderTarget(b))}let Zt=B[It];Zt===void 0&&(Zt=new an,Zt.layers.enable(It),Zt.viewport=new ue,B[It]=Zt),Zt.matrix.fromArray(Kt.transform.matrix),Zt.matrix.decompose(Zt.position,Zt.quaternion,Zt.scale),Zt.projectionMatrix.fromArray(Kt.projectionMatrix),Zt.projectionMatrixInverse.copy(Zt.projectionMatrix).invert(),Zt.viewport.set(oe.x,oe.y,oe.width,oe.height),It===0&&(q.matrix.copy(Zt.matrix),q.matrix.decompose(q.position,q.quaternion,q.scale)),ht===!0&&q.cameras.push(Zt)}let rt=s.enabledFeatures;if(rt&&rt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){d=i.getBinding();let It=d.getDepthInformation(it[0]);It&&It.isValid&&It.texture&&g.init(It,s.renderState)}if(rt&&rt.includes("camera-access")&&_){t.state.unbindTexture(),d=i.getBinding();for(let It=0;It<it.length;It++){let Kt=it[It].camera;if(Kt){let oe=m[Kt];oe||(oe=new Ar,m[Kt]=oe);let Zt=d.getCameraImage(Kt);oe.sourceTexture=Zt}}}}for(let it=0;it<T.length;it++){let ht=w[it],rt=T[it];ht!==null&&rt!==void 0&&rt.update(ht,z,l||o)}j&&j(R,z),z.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:z}),f=null}let $=new Jf;$.setAnimationLoop(ot),this.setAnimationLoop=function(R){j=R},this.dispose=function(){}}},wb=new Jt,op=new zt;op.set(-1,0,0,0,1,0,0,0,1);function Eb(n,t){function e(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,mh(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,y,E,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),d(g,m)):m.isMeshPhongMaterial?(r(g,m),h(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),u(g,m),m.isMeshPhysicalMaterial&&p(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),f(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),_(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?c(g,m,y,E):m.isSpriteMaterial?l(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,e(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===hn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,e(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===hn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,e(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,e(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let y=t.get(m),E=y.envMap,b=y.envMapRotation;E&&(g.envMap.value=E,g.envMapRotation.value.setFromMatrix4(wb.makeRotationFromEuler(b)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(op),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function c(g,m,y,E){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*y,g.scale.value=E*.5,m.map&&(g.map.value=m.map,e(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function l(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function h(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function d(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function u(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function p(g,m,y){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===hn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,g.specularIntensityMapTransform))}function f(g,m){m.matcap&&(g.matcap.value=m.matcap)}function _(g,m){let y=t.get(m).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Ab(n,t,e,i){let s={},r={};function o(y,E){let b=E.program;i.uniformBlockBinding(y,b,s[y.id])}function a(y,E){let b=s[y.id];b===void 0&&(f(y),b=c(y),s[y.id]=b,y.addEventListener("dispose",g));let T=E.program;i.updateUBOMapping(y,T);let w=t.render.frame;r[y.id]!==w&&(l(y),r[y.id]=w)}function c(y){let E=n.createBuffer(),b=y.__size,T=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,b,T),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function l(y){let E=s[y.id],b=y.uniforms,T=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let w=0,x=b.length;w<x;w++){let M=b[w];if(Array.isArray(M))for(let D=0,P=M.length;D<P;D++)h(M[D],w,D,T);else h(M,w,0,T)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(y,E,b,T){if(u(y,E,b,T)===!0){let w=y.__offset,x=y.value;if(Array.isArray(x)){let M=0;for(let D=0;D<x.length;D++){let P=x[D],O=_(P,!0);d(P,y.__data,M),M+=O.storage/Float32Array.BYTES_PER_ELEMENT}}else d(x,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,w,y.__data)}}function d(y,E,b){typeof y=="number"||typeof y=="boolean"?E[b]=y:y.isMatrix3?(E[b]=y.elements[0],E[b+1]=y.elements[1],E[b+2]=y.elements[2],E[b+3]=0,E[b+4]=y.elements[3],E[b+5]=y.elements[4],E[b+6]=y.elements[5],E[b+7]=0,E[b+8]=y.elements[6],E[b+9]=y.elements[7],E[b+10]=y.elements[8],E[b+11]=0):ArrayBuffer.isView(y)?E.set(y.subarray(0,E.length-b),b):y.toArray(E,b)}function u(y,E,b,T){let w=y.value,x=E+"_"+b;if(Array.isArray(w)){T[x]===void 0&&(T[x]=[]);let M=T[x],D=!1;for(let P=0;P<w.length;P++)p(w[P],M,P)===!0&&(D=!0);return D}return p(w,T,x)}function p(y,E,b){if(E[b]===void 0)return typeof y=="number"||typeof y=="boolean"?E[b]=y:ArrayBuffer.isView(y)?E[b]=y.slice():E[b]=y.clone(),!0;{let T=E[b];if(typeof y=="number"||typeof y=="boolean"){if(T!==y)return E[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(T.equals(y)===!1)return T.copy(y),!0}}return!1}function f(y){let E=y.uniforms,b=0,T=16;for(let x=0,M=E.length;x<M;x++){let D=Array.isArray(E[x])?E[x]:[E[x]];for(let P=0,O=D.length;P<O;P++){let B=D[P],q=Array.isArray(B.value)?B.value:[B.value],I=Array.isArray(E[x])||Array.isArray(B.value),V=b;for(let W=0,st=q.length;W<st;W++){let F=q[W],X=_(F,I),j=b%T,ot=j%X.boundary,$=j+ot;b+=ot,$!==0&&T-$<X.storage&&(b+=T-$),W===0&&(V=b),b+=X.storage}let Y=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new Y((b-V)/Float32Array.BYTES_PER_ELEMENT),B.__offset=V}}let w=b%T;return w>0&&(b+=T-w),y.__size=b,y.__cache={},this}function _(y,E){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?Ot("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):Ot("WebGLRenderer: Unsupported uniform value type.",y),E===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(y){let E=y.target;E.removeEventListener("dispose",g),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function m(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:m}}var Tb=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Zn=null;function Cb(){return Zn===null&&(Zn=new vr(Tb,16,16,Oi,Gn),Zn.name="DFG_LUT",Zn.minFilter=cn,Zn.magFilter=cn,Zn.wrapS=qn,Zn.wrapT=qn,Zn.generateMipmaps=!1,Zn.needsUpdate=!0),Zn}var gc=class{constructor(t={}){let{canvas:e=bf(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:p=pn}=t;this.isWebGLRenderer=!0;let f;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");f=i.getContextAttributes().alpha}else f=o;let _=p,g=new Set([Na,Da,La]),m=new Set([pn,kn,Bs,ts,Ra,Pa]),y=new Uint32Array(4),E=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},T=null,w=null,x=[],M=[],D=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Yn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,O=!1,B=null,q=null,I=null,V=null;this._outputColorSpace=on;let Y=0,W=0,st=null,F=-1,X=null,j=new ue,ot=new ue,$=null,R=new kt(0),z=0,it=e.width,ht=e.height,rt=1,Ct=null,re=null,It=new ue(0,0,it,ht),Kt=new ue(0,0,it,ht),oe=!1,Zt=new Ai,Re=new sa,Ee=!1,en=!1,J=new Jt,vt=new C,lt=new ue,Lt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Yt=!1;function be(){return st===null?rt:1}let U=i;function nn(S,N){return e.getContext(S,N)}let de,xe,St,Pe,Ft,Gt,A,v,G,at,nt,dt,_t,Q,tt,pt,L,et,K,mt,ut,ft,Pt;try{let S={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Nt,!1),e.addEventListener("webglcontextrestored",Xt,!1),e.addEventListener("webglcontextcreationerror",bt,!1),U===null){let N="webgl2";if(U=nn(N,S),U===null)throw nn(N)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}qt()}catch(S){throw e.removeEventListener("webglcontextlost",Nt,!1),e.removeEventListener("webglcontextrestored",Xt,!1),e.removeEventListener("webglcontextcreationerror",bt,!1),Bt("WebGLRenderer: "+S.message),S}function qt(){de=new zv(U),de.init(),ut=new Sb(U,de),xe=new Cv(U,de,t,ut),St=new yb(U,de),xe.reversedDepthBuffer&&u&&St.buffers.depth.setReversed(!0),q=U.createFramebuffer(),I=U.createFramebuffer(),V=U.createFramebuffer(),Pe=new Vv(U),Ft=new rb,Gt=new vb(U,de,St,Ft,xe,ut,Pe),A=new Bv(P),v=new W_(U),ft=new Av(U,v),G=new kv(U,v,Pe,ft),at=new Wv(U,G,v,ft,Pe),et=new Hv(U,xe,Gt),tt=new Rv(Ft),nt=new sb(P,A,de,xe,ft,tt),dt=new Eb(P,Ft),_t=new ab,Q=new fb(de),L=new Ev(P,A,St,at,f,c),pt=new xb(P,at,xe),Pt=new Ab(U,Pe,xe,St),K=new Tv(U,de,Pe),mt=new Gv(U,de,Pe),Pe.programs=nt.programs,P.capabilities=xe,P.extensions=de,P.properties=Ft,P.renderLists=_t,P.shadowMap=pt,P.state=St,P.info=Pe}_!==pn&&(D=new qv(_,e.width,e.height,a,s,r));let ct=new Dh(P,U);this.xr=ct,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let S=de.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){let S=de.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return rt},this.setPixelRatio=function(S){S!==void 0&&(rt=S,this.setSize(it,ht,!1))},this.getSize=function(S){return S.set(it,ht)},this.setSize=function(S,N,Z=!0){if(ct.isPresenting){Ot("WebGLRenderer: Can't change size while VR device is presenting.");return}it=S,ht=N,e.width=Math.floor(S*rt),e.height=Math.floor(N*rt),Z===!0&&(e.style.width=S+"px",e.style.height=N+"px"),D!==null&&D.setSize(e.width,e.height),this.setViewport(0,0,S,N)},this.getDrawingBufferSize=function(S){return S.set(it*rt,ht*rt).floor()},this.setDrawingBufferSize=function(S,N,Z){it=S,ht=N,rt=Z,e.width=Math.floor(S*Z),e.height=Math.floor(N*Z),this.setViewport(0,0,S,N)},this.setEffects=function(S){if(_===pn){Bt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(S){for(let N=0;N<S.length;N++)if(S[N].isOutputPass===!0){Ot("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(S||[])},this.getCurrentViewport=function(S){return S.copy(j)},this.getViewport=function(S){return S.copy(It)},this.setViewport=function(S,N,Z,k){S.isVector4?It.set(S.x,S.y,S.z,S.w):It.set(S,N,Z,k),St.viewport(j.copy(It).multiplyScalar(be()).round())},this.getScissor=function(S){return S.copy(Kt)},this.setScissor=function(S,N,Z,k){S.isVector4?Kt.set(S.x,S.y,S.z,S.w):Kt.set(S,N,Z,k),St.scissor(ot.copy(Kt).multiplyScalar(be()).round())},this.getScissorTest=function(){return oe},this.setScissorTest=function(S){St.setScissorTest(oe=S)},this.setOpaqueSort=function(S){Ct=S},this.setTransparentSort=function(S){re=S},this.getClearColor=function(S){return S.copy(L.getClearColor())},this.setClearColor=function(){L.setClearColor(...arguments)},this.getClearAlpha=function(){return L.getClearAlpha()},this.setClearAlpha=function(){L.setClearAlpha(...arguments)},this.clear=function(S=!0,N=!0,Z=!0){let k=0;if(S){let H=!1;if(st!==null){let xt=st.texture.format;H=g.has(xt)}if(H){let xt=st.texture.type,wt=m.has(xt),gt=L.getClearColor(),Mt=L.getClearAlpha(),Rt=gt.r,Ht=gt.g,jt=gt.b;wt?(y[0]=Rt,y[1]=Ht,y[2]=jt,y[3]=Mt,U.clearBufferuiv(U.COLOR,0,y)):(E[0]=Rt,E[1]=Ht,E[2]=jt,E[3]=Mt,U.clearBufferiv(U.COLOR,0,E))}else k|=U.COLOR_BUFFER_BIT}N&&(k|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Z&&(k|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k!==0&&U.clear(k)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(S){S.setRenderer(this),B=S},this.dispose=function(){e.removeEventListener("webglcontextlost",Nt,!1),e.removeEventListener("webglcontextrestored",Xt,!1),e.removeEventListener("webglcontextcreationerror",bt,!1),L.dispose(),_t.dispose(),Q.dispose(),Gt.dispose(),Ft.dispose(),A.dispose(),at.dispose(),G.dispose(),ft.dispose(),Pt.dispose(),nt.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",Ju),ct.removeEventListener("sessionend",Ku),ki.stop()};function Nt(S){S.preventDefault(),mr("WebGLRenderer: Context Lost."),O=!0}function Xt(){mr("WebGLRenderer: Context Restored."),O=!1;let S=Pe.autoReset,N=pt.enabled,Z=pt.autoUpdate,k=pt.needsUpdate,H=pt.type;qt(),Pe.autoReset=S,pt.enabled=N,pt.autoUpdate=Z,pt.needsUpdate=k,pt.type=H}function bt(S){Bt("WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function fe(S){let N=S.target;N.removeEventListener("dispose",fe),Oe(N)}function Oe(S){xi(S),Ft.remove(S)}function xi(S){let N=Ft.get(S).programs;N!==void 0&&(N.forEach(function(Z){nt.releaseProgram(Z)}),S.isShaderMaterial&&nt.releaseShaderCache(S))}this.renderBufferDirect=function(S,N,Z,k,H,xt){N===null&&(N=Lt);let wt=H.isMesh&&H.matrixWorld.determinantAffine()<0,gt=V0(S,N,Z,k,H);St.setMaterial(k,wt);let Mt=Z.index,Rt=1;if(k.wireframe===!0){if(Mt=G.getWireframeAttribute(Z),Mt===void 0)return;Rt=2}let Ht=Z.drawRange,jt=Z.attributes.position,At=Ht.start*Rt,Qt=(Ht.start+Ht.count)*Rt;xt!==null&&(At=Math.max(At,xt.start*Rt),Qt=Math.min(Qt,(xt.start+xt.count)*Rt)),Mt!==null?(At=Math.max(At,0),Qt=Math.min(Qt,Mt.count)):jt!=null&&(At=Math.max(At,0),Qt=Math.min(Qt,jt.count));let Te=Qt-At;if(Te<0||Te===1/0)return;ft.setup(H,k,gt,Z,Mt);let ye,me=K;if(Mt!==null&&(ye=v.get(Mt),me=mt,me.setIndex(ye)),H.isMesh)k.wireframe===!0?(St.setLineWidth(k.wireframeLinewidth*be()),me.setMode(U.LINES)):me.setMode(U.TRIANGLES);else if(H.isLine){let Ye=k.linewidth;Ye===void 0&&(Ye=1),St.setLineWidth(Ye*be()),H.isLineSegments?me.setMode(U.LINES):H.isLineLoop?me.setMode(U.LINE_LOOP):me.setMode(U.LINE_STRIP)}else H.isPoints?me.setMode(U.POINTS):H.isSprite&&me.setMode(U.TRIANGLES);if(H.isBatchedMesh)if(de.get("WEBGL_multi_draw"))me.renderMultiDraw(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount);else{let Ye=H._multiDrawStarts,Tt=H._multiDrawCounts,sn=H._multiDrawCount,ae=Mt?v.get(Mt).bytesPerElement:1,Gi=Ft.get(k).currentProgram.getUniforms();for(let Ze=0;Ze<sn;Ze++)Gi.setValue(U,"_gl_DrawID",Ze),me.render(Ye[Ze]/ae,Tt[Ze])}else if(H.isInstancedMesh)me.renderInstances(At,Te,H.count);else if(Z.isInstancedBufferGeometry){let Ye=Z._maxInstanceCount!==void 0?Z._maxInstanceCount:1/0,Tt=Math.min(Z.instanceCount,Ye);me.renderInstances(At,Te,Tt)}else me.render(At,Te)};function Zu(S,N,Z,k){B!==null&&S.isNodeMaterial&&B.setObject(k,S),Ee===!0&&tt.setState(S,Z,!1),S.transparent===!0&&S.side===ke&&S.forceSinglePass===!1?(S.side=hn,S.needsUpdate=!0,tr(S,N,k),S.side=Ni,S.needsUpdate=!0,tr(S,N,k),S.side=ke):tr(S,N,k)}this.compile=function(S,N,Z=null){Z===null&&(Z=S),B!==null&&B.renderStart(S,N,Z),w=Q.get(Z),w.init(N),M.push(w),Z.traverseVisible(function(H){H.isLight&&H.layers.test(N.layers)&&(w.pushLight(H),H.castShadow&&w.pushShadow(H))}),S!==Z&&S.traverseVisible(function(H){H.isLight&&H.layers.test(N.layers)&&(w.pushLight(H),H.castShadow&&w.pushShadow(H))}),w.setupLights(),B!==null&&B.updateLights(w.state.lightsArray),en=this.localClippingEnabled,Ee=tt.init(this.clippingPlanes,en),Ee===!0&&tt.setGlobalState(this.clippingPlanes,N),B!==null&&pt.render(w.state.shadowsArray,Z,N);let k=new Set;return S.traverse(function(H){if(!(H.isMesh||H.isPoints||H.isLine||H.isSprite))return;let xt=H.material;if(xt)if(Array.isArray(xt))for(let wt=0;wt<xt.length;wt++){let gt=xt[wt];Zu(gt,Z,N,H),k.add(gt)}else Zu(xt,Z,N,H),k.add(xt)}),w=M.pop(),B!==null&&B.renderEnd(),k},this.compileAsync=function(S,N,Z=null){let k=this.compile(S,N,Z);return new Promise(H=>{function xt(){if(k.forEach(function(wt){let Mt=Ft.get(wt).currentProgram;(Mt===void 0||Mt.isReady())&&k.delete(wt)}),k.size===0){H(S);return}setTimeout(xt,10)}de.get("KHR_parallel_shader_compile")!==null?xt():setTimeout(xt,10)})};let al=null;function k0(S){al&&al(S)}function Ju(){ki.stop()}function Ku(){ki.start()}let ki=new Jf;ki.setAnimationLoop(k0),typeof self<"u"&&ki.setContext(self),this.setAnimationLoop=function(S){al=S,ct.setAnimationLoop(S),S===null?ki.stop():ki.start()},ct.addEventListener("sessionstart",Ju),ct.addEventListener("sessionend",Ku),this.render=function(S,N){if(N!==void 0&&N.isCamera!==!0){Bt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(O===!0)return;B!==null&&B.renderStart(S,N);let Z=ct.enabled===!0&&ct.isPresenting===!0,k=D!==null&&(st===null||Z)&&D.begin(P,st);if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),N.parent===null&&N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(N),N=ct.getCamera()),S.isScene===!0&&S.onBeforeRender(P,S,N,st),w=Q.get(S,M.length),w.init(N),w.state.textureUnits=Gt.getTextureUnits(),M.push(w),J.multiplyMatrices(N.projectionMatrix,N.matrixWorldInverse),N.isArrayCamera?Re.setFromArrayCamera(N):Zt.setFromProjectionMatrix(J,An,N.reversedDepth),en=this.localClippingEnabled,Ee=tt.init(this.clippingPlanes,en),T=_t.get(S,x.length),T.init(),x.push(T),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let wt=P.xr.getDepthSensingMesh();wt!==null&&cl(wt,N,-1/0,P.sortObjects)}cl(S,N,0,P.sortObjects),T.finish(),B!==null&&B.updateLights(w.state.lightsArray),P.sortObjects===!0&&T.sort(Ct,re),Yt=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,Yt&&L.addToRenderList(T,S),this.info.autoReset===!0&&this.info.reset(),Ee===!0&&tt.beginShadows();let H=w.state.shadowsArray;if(pt.render(H,S,N),Ee===!0&&tt.endShadows(),(k&&D.hasRenderPass())===!1){let wt=T.opaque,gt=T.transmissive;if(w.setupLights(),N.isArrayCamera){let Mt=N.cameras;if(gt.length>0)for(let Rt=0,Ht=Mt.length;Rt<Ht;Rt++){let jt=Mt[Rt];Qu(wt,gt,S,jt)}Yt&&L.render(S);for(let Rt=0,Ht=Mt.length;Rt<Ht;Rt++){let jt=Mt[Rt];ju(T,S,jt,jt.viewport)}}else gt.length>0&&Qu(wt,gt,S,N),Yt&&L.render(S),ju(T,S,N)}st!==null&&W===0&&(Gt.updateMultisampleRenderTarget(st),Gt.updateRenderTargetMipmap(st)),k&&D.end(P),S.isScene===!0&&S.onAfterRender(P,S,N),ft.resetDefaultState(),F=-1,X=null,M.pop(),M.length>0?(w=M[M.length-1],Gt.setTextureUnits(w.state.textureUnits),Ee===!0&&tt.setGlobalState(P.clippingPlanes,w.state.camera)):w=null,x.pop(),x.length>0?T=x[x.length-1]:T=null,B!==null&&B.renderEnd()};function cl(S,N,Z,k){if(S.visible===!1)return;if(S.layers.test(N.layers)){if(S.isGroup)Z=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(N);else if(S.isLight)w.pushLight(S),S.castShadow&&w.pushShadow(S);else if(S.isSprite){let wt=N.isArrayCamera?Re:Zt;if(!S.frustumCulled||S.intersectsFrustum(wt)){k&&lt.setFromMatrixPosition(S.matrixWorld).applyMatrix4(J);let gt=at.update(S),Mt=S.material;Mt.visible&&T.push(S,gt,Mt,Z,lt.z,null,N)}}else if(S.isMesh||S.isLine||S.isPoints){let wt=N.isArrayCamera?Re:Zt;if(!S.frustumCulled||S.intersectsFrustum(wt)){let gt=at.update(S),Mt=S.material;if(k&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),lt.copy(S.boundingSphere.center)):(gt.boundingSphere===null&&gt.computeBoundingSphere(),lt.copy(gt.boundingSphere.center)),lt.applyMatrix4(S.matrixWorld).applyMatrix4(J)),Array.isArray(Mt)){let Rt=gt.groups;for(let Ht=0,jt=Rt.length;Ht<jt;Ht++){let At=Rt[Ht],Qt=Mt[At.materialIndex];Qt&&Qt.visible&&T.push(S,gt,Qt,Z,lt.z,At,N)}}else Mt.visible&&T.push(S,gt,Mt,Z,lt.z,null,N)}}}let xt=S.children;for(let wt=0,gt=xt.length;wt<gt;wt++)cl(xt[wt],N,Z,k)}function ju(S,N,Z,k){let{opaque:H,transmissive:xt,transparent:wt}=S;w.setupLightsView(Z),Ee===!0&&tt.setGlobalState(P.clippingPlanes,Z),k&&St.viewport(j.copy(k)),H.length>0&&po(H,N,Z),xt.length>0&&po(xt,N,Z),wt.length>0&&po(wt,N,Z),St.buffers.depth.setTest(!0),St.buffers.depth.setMask(!0),St.buffers.color.setMask(!0),St.setPolygonOffset(!1)}function Qu(S,N,Z,k){if((Z.isScene===!0?Z.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[k.id]===void 0){let At=de.has("EXT_color_buffer_half_float")||de.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[k.id]=new xn(1,1,{generateMipmaps:!0,type:At?Gn:pn,minFilter:pi,samples:Math.max(4,xe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:te.workingColorSpace})}let xt=w.state.transmissionRenderTarget[k.id],wt=k.viewport||j;xt.setSize(wt.z*P.transmissionResolutionScale,wt.w*P.transmissionResolutionScale);let gt=P.getRenderTarget(),Mt=P.getActiveCubeFace(),Rt=P.getActiveMipmapLevel();P.setRenderTarget(xt),P.getClearColor(R),z=P.getClearAlpha(),z<1&&P.setClearColor(16777215,.5),P.clear(),Yt&&L.render(Z);let Ht=P.toneMapping;P.toneMapping=Yn;let jt=k.viewport;if(k.viewport!==void 0&&(k.viewport=void 0),w.setupLightsView(k),Ee===!0&&tt.setGlobalState(P.clippingPlanes,k),po(S,Z,k),Gt.updateMultisampleRenderTarget(xt),Gt.updateRenderTargetMipmap(xt),de.has("WEBGL_multisampled_render_to_texture")===!1){let At=!1;for(let Qt=0,Te=N.length;Qt<Te;Qt++){let ye=N[Qt],{object:me,geometry:Ye,material:Tt,group:sn}=ye;if(Tt.side===ke&&me.layers.test(k.layers)){let ae=Tt.side;Tt.side=hn,Tt.needsUpdate=!0,td(me,Z,k,Ye,Tt,sn),Tt.side=ae,Tt.needsUpdate=!0,At=!0}}At===!0&&(Gt.updateMultisampleRenderTarget(xt),Gt.updateRenderTargetMipmap(xt))}P.setRenderTarget(gt,Mt,Rt),P.setClearColor(R,z),jt!==void 0&&(k.viewport=jt),P.toneMapping=Ht}function po(S,N,Z){let k=N.isScene===!0?N.overrideMaterial:null;for(let H=0,xt=S.length;H<xt;H++){let wt=S[H],{object:gt,geometry:Mt,group:Rt}=wt,Ht=wt.material;Ht.allowOverride===!0&&k!==null&&(Ht=k),gt.layers.test(Z.layers)&&td(gt,N,Z,Mt,Ht,Rt)}}function td(S,N,Z,k,H,xt){B!==null&&H.isNodeMaterial&&B.setObject(S,H),S.onBeforeRender(P,N,Z,k,H,xt),S.modelViewMatrix.multiplyMatrices(Z.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),H.onBeforeRender(P,N,Z,k,S,xt),H.transparent===!0&&H.side===ke&&H.forceSinglePass===!1?(H.side=hn,H.needsUpdate=!0,P.renderBufferDirect(Z,N,k,H,S,xt),H.side=Ni,H.needsUpdate=!0,P.renderBufferDirect(Z,N,k,H,S,xt),H.side=ke):P.renderBufferDirect(Z,N,k,H,S,xt),S.onAfterRender(P,N,Z,k,H,xt)}function ed(S){let N=0;for(let Z of S)Z.texture!==null&&N++;return N}function tr(S,N,Z){N.isScene!==!0&&(N=Lt);let k=Ft.get(S),H=w.state.lights,xt=w.state.shadowsArray,wt=H.state.version,gt=nt.getParameters(S,H.state,xt,N,Z,w.state.lightProbeGridArray),Mt=nt.getProgramCacheKey(gt),Rt=k.programs;k.environment=S.isMeshStandardMaterial||S.isMeshLambertMaterial||S.isMeshPhongMaterial?N.environment:null,k.fog=N.fog;let Ht=S.isMeshStandardMaterial||S.isMeshLambertMaterial&&!S.envMap||S.isMeshPhongMaterial&&!S.envMap;k.envMap=A.get(S.envMap||k.environment,Ht),k.envMapRotation=k.environment!==null&&S.envMap===null?N.environmentRotation:S.envMapRotation,Rt===void 0&&(S.addEventListener("dispose",fe),Rt=new Map,k.programs=Rt,k.programVariants=new Map);let jt=Rt.get(Mt);if(jt!==void 0){if(k.currentProgram===jt&&k.lightsStateVersion===wt)return id(S,gt),jt}else gt.uniforms=nt.getUniforms(S),B!==null&&S.isNodeMaterial&&B.build(S,Z,gt),S.onBeforeCompile(gt,P),jt=nt.acquireProgram(gt,Mt),Rt.set(Mt,jt),k.uniforms=gt.uniforms;let At=k.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(At.clippingPlanes=tt.uniform),id(S,gt),k.needsLights=W0(S),k.lightsStateVersion=wt,k.needsLights&&(At.ambientLightColor.value=H.state.ambient,At.lightProbe.value=H.state.probe,At.sunLights.value=H.state.sun,At.sunLightShadows.value=H.state.sunShadow,At.directionalLights.value=H.state.directional,At.directionalLightShadows.value=H.state.directionalShadow,At.spotLights.value=H.state.spot,At.spotLightShadows.value=H.state.spotShadow,At.rectAreaLights.value=H.state.rectArea,At.ltc_1.value=H.state.rectAreaLTC1,At.ltc_2.value=H.state.rectAreaLTC2,At.pointLights.value=H.state.point,At.pointLightShadows.value=H.state.pointShadow,At.hemisphereLights.value=H.state.hemi,At.sunShadowMatrix.value=H.state.sunShadowMatrix,At.sunShadowCascade.value=H.state.sunShadowCascade,At.directionalShadowMatrix.value=H.state.directionalShadowMatrix,At.spotLightMatrix.value=H.state.spotLightMatrix,At.spotLightMap.value=H.state.spotLightMap,At.pointShadowMatrix.value=H.state.pointShadowMatrix),k.numLightProbeGrids=ed(w.state.lightProbeGridArray),k.currentProgram=jt,k.uniformsList=null,jt}function G0(S,N,Z,k,H){let xt=Ft.get(S),wt=xt.currentProgram.id+","+k+","+H,gt=xt.programVariants.get(wt);return gt===void 0?(gt=tr(S,N,Z),xt.programVariants.set(wt,gt)):(xt.currentProgram=gt,xt.uniformsList=null,xt.outputColorSpace=k,xt.toneMapping=H),gt}function nd(S){if(S.uniformsList===null){let N=S.currentProgram.getUniforms();S.uniformsList=zs.seqWithValue(N.seq,S.uniforms)}return S.uniformsList}function id(S,N){let Z=Ft.get(S);Z.outputColorSpace=N.outputColorSpace,Z.batching=N.batching,Z.batchingColor=N.batchingColor,Z.instancing=N.instancing,Z.instancingColor=N.instancingColor,Z.instancingMorph=N.instancingMorph,Z.skinning=N.skinning,Z.morphTargets=N.morphTargets,Z.morphNormals=N.morphNormals,Z.morphColors=N.morphColors,Z.morphTargetsCount=N.morphTargetsCount,Z.numClippingPlanes=N.numClippingPlanes,Z.numIntersection=N.numClipIntersection,Z.vertexAlphas=N.vertexAlphas,Z.vertexTangents=N.vertexTangents,Z.toneMapping=N.toneMapping}function V0(S,N,Z,k,H){N.isScene!==!0&&(N=Lt),Gt.resetTextureUnits();let xt=N.fog,wt=k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial?N.environment:null,gt=st===null?P.outputColorSpace:st.isXRRenderTarget===!0?st.texture.colorSpace:te.workingColorSpace,Mt=k.isMeshStandardMaterial||k.isMeshLambertMaterial&&!k.envMap||k.isMeshPhongMaterial&&!k.envMap,Rt=A.get(k.envMap||wt,Mt),Ht=k.vertexColors===!0&&!!Z.attributes.color&&Z.attributes.color.itemSize===4,jt=!!Z.attributes.tangent&&(!!k.normalMap||k.anisotropy>0),At=!!Z.morphAttributes.position,Qt=!!Z.morphAttributes.normal,Te=!!Z.morphAttributes.color,ye=Yn;k.toneMapped&&(st===null||st.isXRRenderTarget===!0)&&(ye=P.toneMapping);let me=Z.morphAttributes.position||Z.morphAttributes.normal||Z.morphAttributes.color,Ye=me!==void 0?me.length:0,Tt=Ft.get(k),sn=w.state.lights;if(Ee===!0&&(en===!0||S!==X)){let Me=S===X&&k.id===F;tt.setState(k,S,Me)}let ae=!1,Gi=!1;k.version===Tt.__version?Tt.needsLights&&Tt.lightsStateVersion!==sn.state.version||H.isBatchedMesh&&Tt.batching===!1||!H.isBatchedMesh&&Tt.batching===!0||H.isBatchedMesh&&Tt.batchingColor===!0&&H._colorsTexture===null||H.isBatchedMesh&&Tt.batchingColor===!1&&H._colorsTexture!==null||H.isInstancedMesh&&Tt.instancing===!1||!H.isInstancedMesh&&Tt.instancing===!0||H.isSkinnedMesh&&Tt.skinning===!1||!H.isSkinnedMesh&&Tt.skinning===!0||H.isInstancedMesh&&Tt.instancingColor===!0&&H.instanceColor===null||H.isInstancedMesh&&Tt.instancingColor===!1&&H.instanceColor!==null||H.isInstancedMesh&&Tt.instancingMorph===!0&&H.morphTexture===null||H.isInstancedMesh&&Tt.instancingMorph===!1&&H.morphTexture!==null||Tt.envMap!==Rt||k.fog===!0&&Tt.fog!==xt||Tt.numClippingPlanes!==void 0&&(Tt.numClippingPlanes!==tt.numPlanes||Tt.numIntersection!==tt.numIntersection)||Tt.vertexAlphas!==Ht||Tt.vertexTangents!==jt||Tt.morphTargets!==At||Tt.morphNormals!==Qt||Tt.morphColors!==Te||Tt.morphTargetsCount!==Ye||Tt.numLightProbeGrids!==ed(w.state.lightProbeGridArray)?ae=!0:(Tt.outputColorSpace!==gt||Tt.toneMapping!==ye)&&(Gi=!0):(ae=!0,Tt.__version=k.version);let Ze=Tt.currentProgram;(ae===!0||Gi===!0)&&(Ze=Gi===!0?G0(k,N,H,gt,ye):tr(k,N,H),B&&k.isNodeMaterial&&B.onUpdateProgram(k,Ze,Tt));let mo=!1,yi=!1,Vi=!1,ie=Ze.getUniforms(),Ve=Tt.uniforms;if(St.useProgram(Ze.program)&&(mo=!0,yi=!0,Vi=!0),k.id!==F&&(F=k.id,yi=!0),mo||X!==S){St.buffers.depth.getReversed()&&S.reversedDepth!==!0&&(S._reversedDepth=!0,S.updateProjectionMatrix()),ie.setValue(U,"projectionMatrix",S.projectionMatrix),ie.setValue(U,"viewMatrix",S.matrixWorldInverse);let Ue=ie.map.cameraPosition;Ue!==void 0&&Ue.setValue(U,vt.setFromMatrixPosition(S.matrixWorld)),xe.logarithmicDepthBuffer&&ie.setValue(U,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),(k.isMeshPhongMaterial||k.isMeshToonMaterial||k.isMeshLambertMaterial||k.isMeshBasicMaterial||k.isMeshStandardMaterial||k.isShaderMaterial)&&ie.setValue(U,"isOrthographic",S.isOrthographicCamera===!0),X!==S&&(X=S,yi=!0,Vi=!0)}if(Tt.needsLights&&(sn.state.sunShadowMap.length>0&&ie.setValue(U,"sunShadowMap",sn.state.sunShadowMap,Gt),sn.state.directionalShadowMap.length>0&&ie.setValue(U,"directionalShadowMap",sn.state.directionalShadowMap,Gt),sn.state.spotShadowMap.length>0&&ie.setValue(U,"spotShadowMap",sn.state.spotShadowMap,Gt),sn.state.pointShadowMap.length>0&&ie.setValue(U,"pointShadowMap",sn.state.pointShadowMap,Gt)),H.isSkinnedMesh){ie.setOptional(U,H,"bindMatrix"),ie.setOptional(U,H,"bindMatrixInverse");let Me=H.skeleton;Me&&(Me.boneTexture===null&&Me.computeBoneTexture(),ie.setValue(U,"boneTexture",Me.boneTexture,Gt))}H.isBatchedMesh&&(ie.setOptional(U,H,"batchingTexture"),ie.setValue(U,"batchingTexture",H._matricesTexture,Gt),ie.setOptional(U,H,"batchingIdTexture"),ie.setValue(U,"batchingIdTexture",H._indirectTexture,Gt),ie.setOptional(U,H,"batchingColorTexture"),H._colorsTexture!==null&&ie.setValue(U,"batchingColorTexture",H._colorsTexture,Gt));let Dn=Z.morphAttributes;if((Dn.position!==void 0||Dn.normal!==void 0||Dn.color!==void 0)&&et.update(H,Z,Ze),(yi||Tt.receiveShadow!==H.receiveShadow)&&(Tt.receiveShadow=H.receiveShadow,ie.setValue(U,"receiveShadow",H.receiveShadow)),(k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial)&&k.envMap===null&&N.environment!==null&&(Ve.envMapIntensity.value=N.environmentIntensity),Ve.dfgLUT!==void 0&&(Ve.dfgLUT.value=Cb()),yi){if(ie.setValue(U,"toneMappingExposure",P.toneMappingExposure),Tt.needsLights&&H0(Ve,Vi),xt&&k.fog===!0&&dt.refreshFogUniforms(Ve,xt),dt.refreshMaterialUniforms(Ve,k,rt,ht,w.state.transmissionRenderTarget[S.id]),Tt.needsLights&&Tt.numLightProbeGrids>0){let Me=b,Ue=0;for(let ii of w.state.lightProbeGridArray)ii.texture!==null&&(Me.textures[Ue]=ii.texture,Me.min[Ue]=ii.boundingBox.min,Me.max[Ue]=ii.boundingBox.max,Me.resolution[Ue]=ii.resolution,Ue++);for(let ii in Me)Me[ii].length=Ue;Ve.probesSH.value=Me.textures,Ve.probesMin.value=Me.min,Ve.probesMax.value=Me.max,Ve.probesResolution.value=Me.resolution}zs.upload(U,nd(Tt),Ve,Gt)}if(k.isShaderMaterial&&k.uniformsNeedUpdate===!0&&(zs.upload(U,nd(Tt),Ve,Gt),k.uniformsNeedUpdate=!1),k.isSpriteMaterial&&ie.setValue(U,"center",H.center),ie.setValue(U,"modelViewMatrix",H.modelViewMatrix),ie.setValue(U,"normalMatrix",H.normalMatrix),ie.setValue(U,"modelMatrix",H.matrixWorld),k.uniformsGroups!==void 0){let Me=k.uniformsGroups;for(let Ue=0,ii=Me.length;Ue<ii;Ue++){let rd=Me[Ue];Pt.update(rd,Ze),Pt.bind(rd,Ze)}}return Ze}function H0(S,N){S.ambientLightColor.needsUpdate=N,S.lightProbe.needsUpdate=N,S.sunLights.needsUpdate=N,S.sunLightShadows.needsUpdate=N,S.directionalLights.needsUpdate=N,S.directionalLightShadows.needsUpdate=N,S.pointLights.needsUpdate=N,S.pointLightShadows.needsUpdate=N,S.spotLights.needsUpdate=N,S.spotLightShadows.needsUpdate=N,S.rectAreaLights.needsUpdate=N,S.hemisphereLights.needsUpdate=N}function W0(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return st},this.setRenderTargetTextures=function(S,N,Z){let k=Ft.get(S);k.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,k.__autoAllocateDepthBuffer===!1&&(k.__useRenderToTexture=!1),Ft.get(S.texture).__webglTexture=N,Ft.get(S.depthTexture).__webglTexture=k.__autoAllocateDepthBuffer?void 0:Z,k.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,N){let Z=Ft.get(S);Z.__webglFramebuffer=N,Z.__useDefaultFramebuffer=N===void 0},this.setRenderTarget=function(S,N=0,Z=0){st=S,Y=N,W=Z;let k=null,H=!1,xt=!1;if(S){let gt=Ft.get(S);if(gt.__useDefaultFramebuffer!==void 0){St.bindFramebuffer(U.FRAMEBUFFER,gt.__webglFramebuffer),j.copy(S.viewport),ot.copy(S.scissor),$=S.scissorTest,St.viewport(j),St.scissor(ot),St.setScissorTest($),F=-1;return}else if(gt.__webglFramebuffer===void 0)Gt.setupRenderTarget(S);else if(gt.__hasExternalTextures)Gt.rebindTextures(S,Ft.get(S.texture).__webglTexture,Ft.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){let Ht=S.depthTexture;if(gt.__boundDepthTexture!==Ht){if(Ht!==null&&Ft.has(Ht)&&(S.width!==Ht.image.width||S.height!==Ht.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Gt.setupDepthRenderbuffer(S)}}let Mt=S.texture;(Mt.isData3DTexture||Mt.isDataArrayTexture||Mt.isCompressedArrayTexture)&&(xt=!0);let Rt=Ft.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(Rt[N])?k=Rt[N][Z]:k=Rt[N],H=!0):S.samples>0&&Gt.useMultisampledRTT(S)===!1?k=Ft.get(S).__webglMultisampledFramebuffer:Array.isArray(Rt)?k=Rt[Z]:k=Rt,j.copy(S.viewport),ot.copy(S.scissor),$=S.scissorTest}else j.copy(It).multiplyScalar(rt).floor(),ot.copy(Kt).multiplyScalar(rt).floor(),$=oe;if(Z!==0&&(k=q),St.bindFramebuffer(U.FRAMEBUFFER,k)&&St.drawBuffers(S,k),St.viewport(j),St.scissor(ot),St.setScissorTest($),H){let gt=Ft.get(S.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+N,gt.__webglTexture,Z)}else if(xt){let gt=N;for(let Mt=0;Mt<S.textures.length;Mt++){let Rt=Ft.get(S.textures[Mt]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+Mt,Rt.__webglTexture,Z,gt)}}else if(S!==null&&Z!==0){let gt=Ft.get(S.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,gt.__webglTexture,Z)}F=-1};function sd(S){let N=Ft.get(S);return(N.__readFormat!==S.format||N.__readType!==S.type)&&(N.__readFormat=S.format,N.__readType=S.type,N.__formatReadable=xe.textureFormatReadable(S.format),N.__typeReadable=xe.textureTypeReadable(S.type)),N}this.readRenderTargetPixels=function(S,N,Z,k,H,xt,wt,gt=0){if(!(S&&S.isWebGLRenderTarget)){Bt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Mt=Ft.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&wt!==void 0&&(Mt=Mt[wt],Array.isArray(Mt)&&(Mt=Mt[0])),Mt){St.bindFramebuffer(U.FRAMEBUFFER,Mt);try{let Rt=S.textures[gt],Ht=Rt.format,jt=Rt.type;S.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+gt);let At=sd(Rt);if(At.__formatReadable===!1){Bt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(At.__typeReadable===!1){Bt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}N>=0&&N<=S.width-k&&Z>=0&&Z<=S.height-H&&U.readPixels(N,Z,k,H,ut.convert(Ht),ut.convert(jt),xt)}finally{let Rt=st!==null?Ft.get(st).__webglFramebuffer:null;St.bindFramebuffer(U.FRAMEBUFFER,Rt)}}},this.readRenderTargetPixelsAsync=async function(S,N,Z,k,H,xt,wt,gt=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Mt=Ft.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&wt!==void 0&&(Mt=Mt[wt],Array.isArray(Mt)&&(Mt=Mt[0])),Mt)if(N>=0&&N<=S.width-k&&Z>=0&&Z<=S.height-H){St.bindFramebuffer(U.FRAMEBUFFER,Mt);let Rt=S.textures[gt],Ht=Rt.format,jt=Rt.type;S.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+gt);let At=sd(Rt);if(At.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(At.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Qt=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,Qt),U.bufferData(U.PIXEL_PACK_BUFFER,xt.byteLength,U.STREAM_READ),U.readPixels(N,Z,k,H,ut.convert(Ht),ut.convert(jt),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let Te=st!==null?Ft.get(st).__webglFramebuffer:null;St.bindFramebuffer(U.FRAMEBUFFER,Te);let ye=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await wf(U,ye,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,Qt),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,xt),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(Qt),U.deleteSync(ye),xt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,N=null,Z=0){let k=Math.pow(2,-Z),H=Math.floor(S.image.width*k),xt=Math.floor(S.image.height*k),wt=N!==null?N.x:0,gt=N!==null?N.y:0;Gt.setTexture2D(S,0),U.copyTexSubImage2D(U.TEXTURE_2D,Z,0,0,wt,gt,H,xt),St.unbindTexture()},this.copyTextureToTexture=function(S,N,Z=null,k=null,H=0,xt=0){let wt,gt,Mt,Rt,Ht,jt,At,Qt,Te,ye=S.isCompressedTexture?S.mipmaps[xt]:S.image;if(Z!==null)wt=Z.max.x-Z.min.x,gt=Z.max.y-Z.min.y,Mt=Z.isBox3?Z.max.z-Z.min.z:1,Rt=Z.min.x,Ht=Z.min.y,jt=Z.isBox3?Z.min.z:0;else{let ie=Math.pow(2,-H);wt=Math.floor(ye.width*ie),gt=Math.floor(ye.height*ie),S.isDataArrayTexture?Mt=ye.depth:S.isData3DTexture?Mt=Math.floor(ye.depth*ie):Mt=1,Rt=0,Ht=0,jt=0}k!==null?(At=k.x,Qt=k.y,Te=k.z):(At=0,Qt=0,Te=0);let me=ut.convert(N.format),Ye=ut.convert(N.type),Tt;N.isData3DTexture?(Gt.setTexture3D(N,0),Tt=U.TEXTURE_3D):N.isDataArrayTexture||N.isCompressedArrayTexture?(Gt.setTexture2DArray(N,0),Tt=U.TEXTURE_2D_ARRAY):(Gt.setTexture2D(N,0),Tt=U.TEXTURE_2D),St.activeTexture(U.TEXTURE0),St.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,N.flipY),St.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,N.premultiplyAlpha),St.pixelStorei(U.UNPACK_ALIGNMENT,N.unpackAlignment);let sn=St.getParameter(U.UNPACK_ROW_LENGTH),ae=St.getParameter(U.UNPACK_IMAGE_HEIGHT),Gi=St.getParameter(U.UNPACK_SKIP_PIXELS),Ze=St.getParameter(U.UNPACK_SKIP_ROWS),mo=St.getParameter(U.UNPACK_SKIP_IMAGES);St.pixelStorei(U.UNPACK_ROW_LENGTH,ye.width),St.pixelStorei(U.UNPACK_IMAGE_HEIGHT,ye.height),St.pixelStorei(U.UNPACK_SKIP_PIXELS,Rt),St.pixelStorei(U.UNPACK_SKIP_ROWS,Ht),St.pixelStorei(U.UNPACK_SKIP_IMAGES,jt);let yi=S.isDataArrayTexture||S.isData3DTexture,Vi=N.isDataArrayTexture||N.isData3DTexture;if(S.isDepthTexture){let ie=Ft.get(S),Ve=Ft.get(N),Dn=Ft.get(ie.__renderTarget),Me=Ft.get(Ve.__renderTarget);St.bindFramebuffer(U.READ_FRAMEBUFFER,Dn.__webglFramebuffer),St.bindFramebuffer(U.DRAW_FRAMEBUFFER,Me.__webglFramebuffer);for(let Ue=0;Ue<Mt;Ue++)yi&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ft.get(S).__webglTexture,H,jt+Ue),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ft.get(N).__webglTexture,xt,Te+Ue)),U.blitFramebuffer(Rt,Ht,Rt+wt,Ht+gt,At,Qt,At+wt,Qt+gt,U.DEPTH_BUFFER_BIT,U.NEAREST);St.bindFramebuffer(U.READ_FRAMEBUFFER,null),St.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(H!==0||S.isRenderTargetTexture||Ft.has(S)){let ie=Ft.get(S),Ve=Ft.get(N);St.bindFramebuffer(U.READ_FRAMEBUFFER,I),St.bindFramebuffer(U.DRAW_FRAMEBUFFER,V);for(let Dn=0;Dn<Mt;Dn++)yi?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,ie.__webglTexture,H,jt+Dn):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,ie.__webglTexture,H),Vi?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ve.__webglTexture,xt,Te+Dn):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Ve.__webglTexture,xt),H!==0?U.blitFramebuffer(Rt,Ht,Rt+wt,Ht+gt,At,Qt,At+wt,Qt+gt,U.COLOR_BUFFER_BIT,U.NEAREST):Vi?U.copyTexSubImage3D(Tt,xt,At,Qt,Te+Dn,Rt,Ht,wt,gt):U.copyTexSubImage2D(Tt,xt,At,Qt,Rt,Ht,wt,gt);St.bindFramebuffer(U.READ_FRAMEBUFFER,null),St.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else Vi?S.isDataTexture||S.isData3DTexture?U.texSubImage3D(Tt,xt,At,Qt,Te,wt,gt,Mt,me,Ye,ye.data):N.isCompressedArrayTexture?U.compressedTexSubImage3D(Tt,xt,At,Qt,Te,wt,gt,Mt,me,ye.data):U.texSubImage3D(Tt,xt,At,Qt,Te,wt,gt,Mt,me,Ye,ye):S.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,xt,At,Qt,wt,gt,me,Ye,ye.data):S.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,xt,At,Qt,ye.width,ye.height,me,ye.data):U.texSubImage2D(U.TEXTURE_2D,xt,At,Qt,wt,gt,me,Ye,ye);St.pixelStorei(U.UNPACK_ROW_LENGTH,sn),St.pixelStorei(U.UNPACK_IMAGE_HEIGHT,ae),St.pixelStorei(U.UNPACK_SKIP_PIXELS,Gi),St.pixelStorei(U.UNPACK_SKIP_ROWS,Ze),St.pixelStorei(U.UNPACK_SKIP_IMAGES,mo),xt===0&&N.generateMipmaps===!0&&N.mipmapsAutoUpdate===!0&&U.generateMipmap(Tt),St.unbindTexture()},this.initRenderTarget=function(S){Ft.get(S).__webglFramebuffer===void 0&&Gt.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?Gt.setTextureCube(S,0):S.isData3DTexture?Gt.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?Gt.setTexture2DArray(S,0):Gt.setTexture2D(S,0),St.unbindTexture()},this.resetState=function(){Y=0,W=0,st=null,St.reset(),ft.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return An}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=te._getDrawingBufferColorSpace(t),e.unpackColorSpace=te._getUnpackColorSpace()}};var Dt=n=>Array.isArray(n)?n:[],tn=(n,t)=>typeof n=="string"&&n!==""?n:t,Ge=n=>Array.isArray(n)&&n.length>=3&&n.slice(0,3).every(Number.isFinite),yc=n=>Ge(n)?n:null,se=n=>Number.isFinite(n)?n:null;function Rb(n){let t=Dt(n?.vertices);if(!t.every(Ge))return{vertices:t.filter(Ge),faces:[]};let e=i=>Array.isArray(i)&&i.length>=3&&i.every(s=>t[s]);return{vertices:t,faces:Dt(n?.faces).filter(e)}}var ap=n=>Dt(n).map(Rb).filter(t=>t.vertices.length>0);function Pb(n){return n?.radius>0&&Ge(n.axis)?{radius:n.radius,axis:n.axis}:null}function Ib(n){if(!n||!Ge(n.up))return null;let t=.5*n.weight*n.factor/n.tension;return Number.isFinite(t)&&t>0?{up:n.up,curvature:t}:null}function Lb(n,t){return{name:tn(n?.name,`cable ${t}`),outlet:yc(n?.outlet),attachment:yc(n?.attachment),diameter:Math.max(0,se(n?.diameter)??0),pulley:Pb(n?.pulley),sag:Ib(n?.sag)}}function Db(n,t){return{name:tn(n?.name,`obstacle ${t}`),parts:ap(n?.parts)}}function Nb(n){let t=Dt(n?.ends);return t.length<6||t.length%6!==0||!t.every(Number.isFinite)?null:{ends:t,count:se(n.count)??t.length/6,every:se(n.every)??1}}var Fh=n=>Array.isArray(n)&&n.length===4&&n.every(Number.isFinite)&&Math.hypot(...n)>0;function Ob({orientations:n,waypoints:t,turn_weight:e}){let i=Dt(n).length;return i===0||i!==Dt(t).length||!n.every(Fh)||!t.every(Ge)?null:{orientations:n,weight:Math.max(0,se(e)??0)}}function Ub(n){return n?{status:tn(n.status,"unknown"),planner:tn(n.planner,null),waypoints:Dt(n.waypoints).filter(Ge),turns:Ob(n),rawWaypoints:Dt(n.raw_waypoints).filter(Ge),cost:se(n.cost),rawCost:se(n.raw_cost),tree:Nb(n.tree)}:null}function Fb(n,t){let e=Dt(n?.vertices).filter(Ge),i=o=>Array.isArray(o)&&o.length===3&&o.every(a=>e[a]),s=tn(n?.name,`region ${t}`),[r=s]=Dt(n?.culprits).map(String);return{name:s,owner:r,kind:tn(n?.kind,"unknown"),vertices:e,faces:Dt(n?.triangles).filter(i)}}function Bb(n){if(!n)return null;let t=Dt(n.meshes).map(Fb);return{space:tn(n.space,"attachment"),shown:n.shown!==!1,meshes:t}}function zb({measure:n,unit:t,values:e}){return{measure:tn(n,"wrench"),unit:tn(t,""),values:Dt(e)}}function kb(n){return{of:tn(n?.of,"obstacles"),gap:Dt(n?.gap),required:Dt(n?.required),tightest:Dt(n?.tightest),pairs:Dt(n?.pairs).map(t=>Dt(t).map(String)),points:Dt(n?.points)}}function Gb(n){let t=({gap:i,required:s},r)=>i[r]-s[r],e=n[0]?.gap.length??0;return Array.from({length:e},(i,s)=>n.reduce((r,o)=>t(o,s)<t(r,s)?o:r))}function Vb(n){if(!n||Dt(n.s).length<2)return null;let t=Dt(n.approaches).map(kb).filter(({gap:i})=>i.length===n.s.length),e=Gb(t);return{s:n.s,lengths:Dt(n.lengths),approaches:t,clearance:e.map(({gap:i},s)=>i[s]),required:e.map(({required:i},s)=>i[s]),culprits:e.map(({pairs:i,tightest:s},r)=>i[s[r]]),tensions:Dt(n.tensions),tensionLimits:Dt(n.tension_limits),distribution:cp(n.distribution),margins:Dt(n.margins).map(zb)}}var cp=n=>typeof n=="string"?n:null,lp=(n,t)=>Object.fromEntries(Object.entries(t).map(([e,i])=>[e,se(n?.[i])])),Hb={speed:"speed",acceleration:"acceleration",turnSpeed:"turn_speed",turnAcceleration:"turn_acceleration",jerk:"jerk",cableSpeed:"cable_speed",cableAcceleration:"cable_acceleration",blend:"blend",wrenchMargin:"wrench_margin"},Wb={speed:"speed",acceleration:"acceleration",cableSpeed:"cable_speed",cableAcceleration:"cable_acceleration",turnSpeed:"turn_speed",turnAcceleration:"turn_acceleration"},Xb=n=>({...lp(n,Wb),tensions:Dt(n.tensions).length===2?n.tensions.map(se):null});function qb(n,t){let e=Dt(n);return e.length===t&&e.every(Fh)?e:null}function $b(n){let t=Dt(n?.times);if(t.length<2||Dt(n.positions).length!==t.length)return null;let e=i=>({at:Dt(i?.times??t),values:Dt(i?.values)});return{duration:t.at(-1),length:se(n.length)??0,limits:lp(n.limits,Hb),tensionLimits:Dt(n.tension_limits),distribution:cp(n.distribution),limiting:Dt(n.limiting).map(({from:i,to:s,limit:r,cable:o})=>({from:i,to:s,kind:String(r),cable:o})),corners:Dt(n.corners),largest:n.largest?Xb(n.largest):null,cables:Dt(n.cables).map(String),times:t,positions:n.positions,orientations:qb(n.orientations,t.length),turnSpeed:n.turn_speed?e(n.turn_speed):null,speed:e(n.speed),acceleration:e(n.acceleration),cableSpeeds:Dt(n.cable_speeds).map(e),tensions:Dt(n.tensions).map(e)}}function Yb(n){if(!n||!Ge(n.origin)||!Ge(n.counts))return null;let t=Dt(n.margins),e=t.reduce((a,c)=>Math.max(a,c??0),0),{origin:i,step:s,counts:r}=n,o=tn(n.measure,"margin");return{origin:i,step:s,counts:r,margins:t,greatest:e,measure:o,unit:tn(n.unit,"")}}function Zb(n){return{obstacle:tn(n?.obstacle,"obstacle"),cost:se(n?.cost),waypoints:Dt(n?.waypoints).filter(Ge)}}var Oh=n=>Dt(n).filter(t=>Array.isArray(t)&&t.length===6);function Jb(n){if(!n||!Dt(n.bounds).every(Ge)||!Ge(n.nearest))return null;let[t,e]=n.bounds,i=Dt(n.culprits).map(s=>Dt(s).map(String));return{min:t,max:e,count:se(n.count)??1,culprits:i,blocking:Dt(n.blocking).map(String),volume:se(n.volume)??0,ofVolume:se(n.of_volume)??0,nearest:n.nearest,toGoal:se(n.to_goal)??0,margin:se(n.margin)??0,reachable:Oh(n.reachable),walls:i.map((s,r)=>Oh(Dt(n.walls)[r])),without:Dt(n.without).map(Zb)}}function Kb({condition:n,share:t,worst:e,pairs:i}){let[s=null,r=null]=Dt(e);return{condition:String(n),share:se(t)??0,names:s,most:r,pairs:se(i)??0}}function Bh(n){if(!n||!Dt(n.bounds).every(Ge))return null;let[t,e]=n.bounds;return{min:t,max:e,count:se(n.count)??1,inside:Oh(n.inside),volume:[se(n.volume?.min)??0,se(n.volume?.max)??0],total:se(n.total)??0,parts:se(n.parts)??1,apart:!!n.apart,taken:Dt(n.taken).map(Kb),orientations:se(n.orientations)??1,validAt:tn(n.valid_at,"every")}}function Uh(n){return{segment:Math.max(0,Math.trunc(se(n?.segment)??0)),at:Math.min(1,Math.max(0,se(n?.at)??0)),time:se(n?.time),kind:tn(n?.kind,"unknown"),culprits:Dt(n?.culprits).map(String),gap:se(n?.gap),required:se(n?.required)??0}}function jb(n){return n?{reason:n.reason?Uh(n.reason):null,reasons:Dt(n.reasons??[n.reason].filter(Boolean)).map(Uh),nearestValid:Ge(n.nearest_valid)?n.nearest_valid:null,openingBelow:se(n.opening_below),seed:se(n.seed),seconds:se(n.seconds),lowerBound:se(n.lower_bound),via:Dt(n.route?.via).filter(Number.isInteger),cost:se(n.cost)}:null}function Qb(n){let{min:t,max:e}=n??{};return Ge(t)&&Ge(e)?{min:t,max:e}:null}var Nh=(n,t=[1,0,0,0])=>Fh(n)?n:t;function jr(n){let t=Dt(n?.cables).map(Lb),e=Nh(n?.orientation);return{title:tn(n?.title,"untitled scene"),workspace:Qb(n?.workspace),orientation:e,platform:ap(n?.platform),cables:t.filter(i=>i.outlet&&i.attachment),obstacles:Dt(n?.obstacles).map(Db),start:yc(n?.start),goal:yc(n?.goal),startOrientation:Nh(n?.start_orientation,e),goalOrientation:Nh(n?.goal_orientation,e),path:Ub(n?.path),result:jb(n?.result),regions:Bb(n?.regions),motion:Vb(n?.motion),trajectory:$b(n?.trajectory),feasible:Yb(n?.feasible),noPath:Jb(n?.no_path),proved:Bh(n?.proved_workspace),violations:Dt(n?.violations).map(Uh)}}var zh=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],Fi=(n,t,e)=>[n[0]+t*e[0],n[1]+t*e[1],n[2]+t*e[2]],up=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],dp=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],kh=n=>Math.hypot(n[0],n[1],n[2]),fp=n=>Fi([0,0,0],1/kh(n),n);function tM(n){let t=n.map(Math.abs);return fp(dp(n,[0,1,2].map(e=>e===t.indexOf(Math.min(...t))?1:0)))}var pp=(n,{radius:t,axis:e},i,s)=>Fi(Fi(n,t*(1-Math.cos(s)),i),t*Math.sin(s),e);function hp(n,t,e){let i=zh(e,n),s=up(t.axis,i),r=Fi(i,-s,t.axis),o=kh(r),a=o>0?fp(r):tM(t.axis),c=o-2*t.radius,l=o*c+s*s;if(!(l>0)||s<0&&c<0)return{wrap:0,side:a,exit:n};let h=Math.sqrt(l),d=2*(s>=0?Math.atan2(o,s+h):Math.atan2(h-s,c));return{wrap:d,side:a,exit:pp(n,t,a,d)}}function eM({outlet:n,pulley:t,sag:e},i){if(!t)return{exit:n};let s=hp(n,t,i);for(let r=0;e&&r<2;r+=1){let o=kh(zh(i,s.exit));s=hp(n,t,Fi(i,-e.curvature*o*o,e.up))}return s}function nM({up:n,curvature:t},e,i){let s=zh(i,e),r=t*up(s,s);return Array.from({length:24},(o,a)=>{let c=(a+1)/24;return c===1?i:Fi(Fi(e,c,s),-r*c*(1-c),n)})}var vc=({pulley:n,sag:t})=>!!(n||t);function mp(n,t){let{outlet:e,pulley:i,sag:s}=n,{exit:r,wrap:o,side:a}=eM(n,t),l=i?Array.from({length:16},(d,u)=>pp(e,i,a,o*(u+1)/16)):[],h=i?{centre:Fi(e,i.radius,a),axle:dp(i.axis,a)}:null;return{points:[e,...l,...s?nM(s,r,t):[t]],wheel:h}}yt.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ut},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};un.line={uniforms:$r.merge([yt.common,yt.fog,yt.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var Gs=class extends Cn{constructor(t){super({type:"LineMaterial",uniforms:$r.clone(un.line.uniforms),vertexShader:un.line.vertexShader,fragmentShader:un.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var gp=new ve,Sc=new C,Vs=class extends Nr{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new he(t,3)),this.setAttribute("uv",new he(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,i=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),i.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let i=new Ii(e,6,1);return this.setAttribute("instanceStart",new zn(i,3,0)),this.setAttribute("instanceEnd",new zn(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let i=new Ii(e,6,1);return this.setAttribute("instanceColorStart",new zn(i,3,0)),this.setAttribute("instanceColorEnd",new zn(i,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new Cr(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ve);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),gp.setFromBufferAttribute(e),this.boundingBox.union(gp))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new fn),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Sc.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Sc)),Sc.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Sc));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var Gh=new ue,_p=new C,xp=new C,We=new ue,Xe=new ue,Jn=new ue,Vh=new C,Hh=new Jt,qe=new Ur,yp=new C,bc=new ve,Mc=new fn,Kn=new ue,jn,ns;function vp(n,t,e){return Kn.set(0,0,-t,1).applyMatrix4(n.projectionMatrix),Kn.multiplyScalar(1/Kn.w),Kn.x=ns/e.width,Kn.y=ns/e.height,Kn.applyMatrix4(n.projectionMatrixInverse),Kn.multiplyScalar(1/Kn.w),Math.abs(Math.max(Kn.x,Kn.y))}function iM(n,t){let e=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,c=o;a<c;a++){qe.start.fromBufferAttribute(s,a),qe.end.fromBufferAttribute(r,a),qe.applyMatrix4(e);let l=new C,h=new C;jn.distanceSqToSegment(qe.start,qe.end,h,l),h.distanceTo(l)<ns*.5&&t.push({point:h,pointOnLine:l,distance:jn.origin.distanceTo(h),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function sM(n,t,e){let i=t.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,c=a.attributes.instanceStart,l=a.attributes.instanceEnd,h=Math.min(a.instanceCount,c.count),d=-t.near;jn.at(1,Jn),Jn.w=1,Jn.applyMatrix4(t.matrixWorldInverse),Jn.applyMatrix4(i),Jn.multiplyScalar(1/Jn.w),Jn.x*=r.x/2,Jn.y*=r.y/2,Jn.z=0,Vh.copy(Jn),Hh.multiplyMatrices(t.matrixWorldInverse,o);for(let u=0,p=h;u<p;u++){if(We.fromBufferAttribute(c,u),Xe.fromBufferAttribute(l,u),We.w=1,Xe.w=1,We.applyMatrix4(Hh),Xe.applyMatrix4(Hh),We.z>d&&Xe.z>d)continue;if(We.z>d){let E=We.z-Xe.z,b=(We.z-d)/E;We.lerp(Xe,b)}else if(Xe.z>d){let E=Xe.z-We.z,b=(Xe.z-d)/E;Xe.lerp(We,b)}We.applyMatrix4(i),Xe.applyMatrix4(i),We.multiplyScalar(1/We.w),Xe.multiplyScalar(1/Xe.w),We.x*=r.x/2,We.y*=r.y/2,Xe.x*=r.x/2,Xe.y*=r.y/2,qe.start.copy(We),qe.start.z=0,qe.end.copy(Xe),qe.end.z=0;let _=qe.closestPointToPointParameter(Vh,!0);qe.at(_,yp);let g=qr.lerp(We.z,Xe.z,_),m=g>=-1&&g<=1,y=Vh.distanceTo(yp)<ns*.5;if(m&&y){qe.start.fromBufferAttribute(c,u),qe.end.fromBufferAttribute(l,u),qe.start.applyMatrix4(o),qe.end.applyMatrix4(o);let E=new C,b=new C;jn.distanceSqToSegment(qe.start,qe.end,b,E),e.push({point:b,pointOnLine:E,distance:jn.origin.distanceTo(b),object:n,face:null,faceIndex:u,uv:null,uv1:null})}}}var wc=class extends ne{constructor(t=new Vs,e=new Gs({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,i=t.attributes.instanceEnd,s=new Float32Array(2*e.count);for(let o=0,a=0,c=e.count;o<c;o++,a+=2)_p.fromBufferAttribute(e,o),xp.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+_p.distanceTo(xp);let r=new Ii(s,2,1);return t.setAttribute("instanceDistanceStart",new zn(r,1,0)),t.setAttribute("instanceDistanceEnd",new zn(r,1,1)),this}raycast(t,e){let i=this.material.worldUnits,s=t.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=t.params.Line2!==void 0&&t.params.Line2.threshold||0;jn=t.ray;let o=this.matrixWorld,a=this.geometry,c=this.material;ns=c.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Mc.copy(a.boundingSphere).applyMatrix4(o);let l;if(i)l=ns*.5;else{let d=Math.max(s.near,Mc.distanceToPoint(jn.origin));l=vp(s,d,c.resolution)}if(Mc.radius+=l,jn.intersectsSphere(Mc)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),bc.copy(a.boundingBox).applyMatrix4(o);let h;if(i)h=ns*.5;else{let d=Math.max(s.near,bc.distanceToPoint(jn.origin));h=vp(s,d,c.resolution)}bc.expandByScalar(h),jn.intersectsBox(bc)!==!1&&(i?iM(this,e):sM(this,s,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(Gh),this.material.uniforms.resolution.value.set(Gh.z,Gh.w))}};var Qr=64,rM=n=>n.flatMap(t=>[t.x,t.y,t.z]);function Pn(n){return n.slice(1).flatMap((t,e)=>[n[e],t])}var is=n=>new Ae().setFromPoints(n);function Sn(n,t=new je){return new br(is(n),t)}var Ec=n=>new Vs().setPositions(rM(n));function pe(n,t){let e=new wc(Ec(n),new Gs(t));return t.dashed&&e.computeLineDistances(),e.frustumCulled=!1,e}function Ac(n){return Object.assign(n.material,{polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-8}),n}function Qn(n,t){let e=n.geometry.attributes.instanceStart.data;t.forEach((i,s)=>i.toArray(e.array,3*s)),e.needsUpdate=!0}function oM(n){let t=document.createElement("canvas");t.width=Qr,t.height=Qr;let e=t.getContext("2d");e.translate(Qr/2,Qr/2),n(e,Qr/2);let i=new Yi(t);return i.colorSpace=on,i}function aM(n,t){n.fillStyle="#fff",n.arc(0,0,t-2,0,2*Math.PI),n.fill()}function cM(n,t,e){let i=t*.62;n.strokeStyle="#fff",n.lineCap="round",n.lineWidth=t*e,n.moveTo(-i,-i),n.lineTo(i,i),n.moveTo(-i,i),n.lineTo(i,-i),n.stroke()}function Sp(n,t,e){let i=new Ls({size:t,map:e,sizeAttenuation:!1,transparent:!0,alphaTest:.5}),s=new Mr(is(n),i);return s.frustumCulled=!1,s}var Wh=new Map;function bp(n,t){return Wh.has(n)||Wh.set(n,oM(t)),Wh.get(n)}var dn=(n,t)=>Sp(n,t,bp("disc",aM));function Xh(n,t,e,i){let r=Sp(n,t,bp(e,(o,a)=>cM(o,a,e)));return r.material.depthTest=!1,r.material.alphaTest=0,r.renderOrder=i,r}var Mp=["#332288","#2f8f80","#aa4499","#117733","#cc6677","#3a9bc4","#882255","#8a8a1f","#b58e1c"],lM=["#77aadd","#ee8866","#eedd88","#ffaabb","#44bb99","#b889f4","#bbcc33","#dddddd","#c95c88"],Bi=Mp.length,Tc=n=>`region${n%Bi}`,Hs=(n,t)=>Object.fromEntries(t.map((e,i)=>[n.replace("#",i),e])),wp=["#cc3311","#882255","#999933","#ee3377","#661100","#aa4499","#777777"],hM=["#661a09","#441129","#4d4d1a","#771a3c","#330800","#552250","#333333"],uM=["#ee5533","#cc4488","#bbbb44","#ff6699","#aa5544","#cc66cc","#999999"],dM=["#f5c5ba","#e8b5cf","#e3e3b5","#fbc6d9","#e6b8b0","#eac6e6","#dddddd"],Ws=n=>`wall${n%wp.length}`,Ep={limitSpeed:"#0072b2",limitAcceleration:"#e69f00",limitTurnSpeed:"#6a3d9a",limitTurnAcceleration:"#f0e442",limitJerk:"#cc79a7",limitCableSpeed:"#56b4e9",limitCableAcceleration:"#d55e00",limitTension:"#009e73"},fM={text:"#1b1f24",muted:"#545c66",panel:"rgb(255 255 255 / 88%)",border:"#c9cfd6",button:"#eceff3",focus:"#0059c9",...Hs("region#",Mp),...Ep,...Hs("wall#",wp),...Hs("wall#Edge",hM),reachable:"#3f8fd0",reachableEdge:"#1d5c94",background:"#f6f7f9",platform:"#0072b2",platformEdge:"#003b5c",obstacle:"#c3b391",obstacleEdge:"#5a4d33",cable:"#2b2f36",outlet:"#000000",rawPath:"#80868f",tree:"#3b7ea1",finalPath:"#009e73",waypoint:"#00664a",ghost:"#b0578d",highlight:"#6a3d9a",frame:"#545c66",workspace:"#8d97a3",floor:"#8d97a3",violation:"#d40000",shadow:"#000000",good:"#00704f",warn:"#8a5a00"},pM={text:"#eceff3",muted:"#a9b1bb",panel:"rgb(30 34 41 / 88%)",border:"#434b56",button:"#333a44",focus:"#8cc4ff",...Hs("region#",lM),...Ep,...Hs("wall#",uM),...Hs("wall#Edge",dM),reachable:"#4ea3e6",reachableEdge:"#a8d4f7",background:"#14171c",platform:"#56b4e9",platformEdge:"#d3edfb",obstacle:"#a39273",obstacleEdge:"#e9dfc9",cable:"#d8dce2",outlet:"#ffffff",rawPath:"#969ca6",tree:"#86bfdc",finalPath:"#14c795",waypoint:"#a5f0d9",ghost:"#e29ac1",highlight:"#d9b8ff",frame:"#a9b1bb",workspace:"#68717d",floor:"#68717d",violation:"#ff6b5e",shadow:"#000000",good:"#3ddbaa",warn:"#f0b23c"};function qh(n){let t=window.matchMedia("(prefers-color-scheme: dark)"),e=new Set,i=null,s=!1,r=()=>!s&&(i??t.matches),o=()=>r()?pM:fM;function a(){let d=o();document.documentElement.style.colorScheme=r()?"dark":"light";for(let[u,p]of Object.entries(d))document.documentElement.style.setProperty(`--${u}`,p);for(let{bound:u,watchers:p}of e){for(let{color:f,role:_}of u)f.set(d[_]);for(let f of p)f()}n()}function c(){let d=[],u=[],p={bound:d,watchers:u};e.add(p);let f=(m,y)=>{d.push({color:m,role:y}),m.set(o()[y])};return{bind:f,paint:(m,y)=>(f(m.color,y),m),watch:m=>u.push(m),release:()=>e.delete(p)}}function l(){i=!r(),a()}function h(d){s=d,a()}return t.addEventListener("change",a),a(),{toggle:l,setPrinting:h,createPainter:c}}var Tp=new C(0,1,0),Ap={radius:.92,width:.25},Cp=(n,t)=>{let e=new $i(n,new ze,t);return e.frustumCulled=!1,e},mM=n=>Cp(new Zi(1,1,1,12,1,!0),n),gM=.2;function _M(n,t,e,i,s){let r=t.clone().sub(n),o=r.length(),a=new we().setFromUnitVectors(Tp,r.divideScalar(o||1));return s.compose(n.clone().add(t).multiplyScalar(.5),a,new C(e,o+i,e))}var xM=(n,{radius:t,axis:e})=>({radius:t*n.scale,axis:e}),yM=(n,{up:t,curvature:e})=>({up:t,curvature:e/n.scale});function $h(n,t){let e={outlet:t.point(n.outlet),arm:t.vector(n.attachment),end:new C,radius:n.diameter/2*t.scale,pulley:n.pulley&&xM(t,n.pulley),sag:n.sag&&yM(t,n.sag),wheel:null};if(!vc(e))return{...e,points:[e.outlet,e.end],lay:()=>{}};let{outlet:i,end:s,pulley:r,sag:o}=e,a=()=>mp({outlet:i.toArray(),pulley:r,sag:o},s.toArray()),c=[i,...a().points.slice(1,-1).map(()=>new C),s],h={...e,points:c,lay:d=>{let{points:u,wheel:p}=a();c.slice(1,-1).forEach((f,_)=>{d?f.fromArray(u[_+1]):f.copy(i).lerp(s,(_+1)/(c.length-1))}),h.wheel=p}};return h}function vM(n,t){let e=n.filter(({pulley:a})=>a),i=Cp(new Zi(1,1,1,40),e.length);t.paint(i.material,"frame");let s=new Jt,r=new we,o=()=>{e.forEach(({pulley:a,wheel:c},l)=>{let h=Ap.radius*a.radius;r.setFromUnitVectors(Tp,new C(...c.axle)),s.compose(new C(...c.centre),r,new C(h,Ap.width*a.radius,h)),i.setMatrixAt(l,s)}),i.instanceMatrix.needsUpdate=!0};return{objects:e.length>0?[i]:[],lay:o}}var SM=.75;function bM(n,t){let e=Array.from({length:n},()=>new kt),i=new kt;return e.forEach((s,r)=>t.bind(s,Tc(r))),t.bind(i,"background"),s=>e.map((r,o)=>s===null||s===o?r:r.clone().lerp(i,SM))}function Rp(n,t,e){let i=n.cables.map(D=>$h(D,t)),s=i.map(({points:D})=>D),r=s.flatMap(Pn),a=i.filter(({radius:D})=>D>0).flatMap(D=>D.points.slice(1).map((P,O)=>({from:D.points[O],to:P,cable:D}))),c=pe(r,{linewidth:1.75,vertexColors:!0}),l=Math.max(2,...s.map(({length:D})=>D)),h=pe(Pn(Array(l).fill(new C)),{linewidth:4.5}),d=mM(a.length),u=vM(i,e),p=bM(i.length,e),f=new Jt,_=null,g=!0;h.visible=!1,h.renderOrder=5,l>2&&Ac(h);function m(){let D=p(_);c.geometry.setColors(D.flatMap((P,O)=>Pn(s[O]).flatMap(()=>P.toArray()))),a.forEach(({cable:P},O)=>d.setColorAt(O,D[i.indexOf(P)])),d.instanceColor&&(d.instanceColor.needsUpdate=!0),_!==null&&h.material.color.copy(D[_])}function y(){h.visible=_!==null,_!==null&&(h.geometry.instanceCount=s[_].length-1,Qn(h,Pn(s[_])))}function E(D){_=D!==null&&D<i.length?D:null,m(),y()}function b(){for(let D of i)D.lay(g);Qn(c,r),a.forEach(({from:D,to:P,cable:O},B)=>{let q=O.points.length>2?gM*O.radius:0;d.setMatrixAt(B,_M(D,P,O.radius,q,f))}),d.instanceMatrix.needsUpdate=!0,u.lay(),y()}function T(D,P){for(let O of i)O.end.copy(O.arm).applyQuaternion(P).add(D);b()}function w(D){g=D;for(let P of u.objects)P.visible=g;b()}i.length>0&&m(),e.watch(m);let x=(D,P)=>i[D].outlet.copy(P);return{parts:i.length>0?[c,d,h]:[],strands:s,wheels:u.objects,light:E,move:T,moveOutlet:x,hang:w}}var Pp=new Map,Cc=null;function ss(n){if(n!==Cc){Cc=n;for(let t of Pp.values())t(Cc)}}function Xs(n,t){Pp.set(n,t),t(Cc)}function Ip(n,t){for(let e of["pointerenter","focusin"])n.addEventListener(e,()=>ss(t));for(let e of["pointerleave","focusout"])n.addEventListener(e,()=>ss(null))}var MM=7;function wM(n,t,e,i){let[s,r]=[i.x-e.x,i.y-e.y],o=Math.min(1,Math.max(0,((n-e.x)*s+(t-e.y)*r)/(s*s+r*r||1)));return Math.hypot(n-e.x-o*s,t-e.y-o*r)}function Lp(n,t,e,i){let{canvas:s}=n,r=a=>{let{x:c,y:l}=new C().copy(a).project(n.camera);return{x:(c+1)/2*s.clientWidth,y:(1-l)/2*s.clientHeight}},o=({pointerType:a,buttons:c,offsetX:l,offsetY:h})=>{if(a!=="mouse"||c!==0)return;let d={index:null,distance:MM};for(let u=0;e()&&u<t.length;u+=1){let p=t[u].map(r);for(let f=1;f<p.length;f+=1){let _=wM(l,h,p[f-1],p[f]);_<d.distance&&(d={index:u,distance:_})}}ss(d.index)};s.addEventListener("pointermove",o,{signal:i}),s.addEventListener("pointerleave",()=>ss(null),{signal:i})}var EM="http://www.w3.org/2000/svg",Rc=300,rs=80,AM=7,TM=1,Pc=n=>`var(--region${n%Bi})`,Dp=[["solid","none"],["dashed","7 3"],["dotted","2 3"]],Up=n=>Dp[Math.floor(n/Bi)%Dp.length];function Vt(n,t,e){let i=document.createElement(n);return i.className=t,e!==void 0&&(i.textContent=e),i}function os(n,t){let e=document.createElementNS(EM,n);for(let[i,s]of Object.entries(t))e.setAttribute(i,s);return e}function Ic(n){let t=Vt("span","swatch line");return t.style.setProperty("--swatch",Pc(n)),[t.style.borderTopStyle]=Up(n),t}var CM=(n,t,e,i)=>{let s=e-t||Math.abs(e)||1;return n>e+i*s||n<t-i*s};function RM(n,t,e){let i=n.reduce((a,c)=>Math.min(a,c)),s=n.reduce((a,c)=>Math.max(a,c)),r=t.filter(a=>!CM(a,i,s,e));i=Math.min(i,...r),s=Math.max(s,...r);let o=(s-i||Math.abs(s)||1)*.04;return{low:i-o,high:s+o}}function Fp(n,t,e){let i="M";return n.map((s,r)=>{if(!Number.isFinite(s))return i="M","";let o=`${i}${t[r].toFixed(1)} ${e(s).toFixed(1)}`;return i="L",o}).join("")}var PM=(n,t)=>os("line",{class:n,x1:0,x2:Rc,y1:t,y2:t}),Np=(n,t)=>os("line",{class:n,x1:t,x2:t,y1:0,y2:rs});function IM(n,t,e){let i=Fp(n,t,e),s=t.at(-1).toFixed(1);return[os("path",{class:"forbidden",d:`${i}L${s} ${rs}L${t[0].toFixed(1)} ${rs}Z`}),os("path",{class:"limit",d:i})]}var LM=n=>os("line",{class:"waypoint",x1:n,x2:n,y1:rs-AM,y2:rs});function DM({name:n,series:t,limits:e,floor:i},{length:s,whole:r,marks:o,ticks:a,corners:c},{low:l,high:h}){let d=_=>rs*(1-(_-l)/(h-l)),u=_=>Rc*_/s,p={viewBox:`0 0 ${Rc} ${rs}`,preserveAspectRatio:"none"},f=os("svg",{...p,role:"img","aria-label":n});for(let _ of a)f.append(Np("tick",Rc*_/r));i&&f.append(...IM(i,t[0].at.map(u),d));for(let _ of o)f.append(Np("fault",u(_)));for(let _ of e)_>=l&&_<=h&&f.append(PM("limit",d(_)));return t.forEach(({at:_,values:g},m)=>{let y=os("path",{class:"curve",d:Fp(g,_.map(u),d)});y.style.stroke=t.length>1?Pc(m):"var(--text)",[,y.style.strokeDasharray]=Up(m),f.append(y)}),f.append(...c.map(_=>LM(u(_)))),f}var Yh=.15;function NM({axis:n,say:t},e,{low:i,high:s}){let r=e.reduce((c,l)=>Math.max(c,l)),o=e.reduce((c,l)=>Math.min(c,l)),a=[];for(let c of new Set([o,r])){let l=(s-c)/(s-i);a.some(h=>Math.abs(h.top-l)<Yh)||a.push({top:l,text:(t??n.format)(c),kind:"scale",value:c})}return a}var OM=4;function UM({limits:n,axis:t,floor:e},{low:i,high:s}){let r=[...n].sort((l,h)=>h-l),o=r.length>OM?[r[0],r.at(-1)]:r,a=[...new Set(e??[])].filter(l=>l>0);return[...o.map(l=>({value:l,word:"limit"})),...a.map(l=>({value:l,word:"min"}))].map(({value:l,word:h})=>{let d={[l>s]:"\u2191 ",[l<i]:"\u2193 "}[!0]??"";return{top:Math.min(1,Math.max(0,(s-l)/(s-i))),text:`${d}${h} ${t.brief(l)}`,kind:"bound"}})}function FM(n){n.sort((e,i)=>e.top-i.top);let t=Math.min(Yh,1/n.length);n.forEach((e,i)=>{e.top=Math.max(e.top,i>0?n[i-1].top+t:0)});for(let e=n.length-1;e>=0;e-=1)n[e].top=Math.min(n[e].top,e+1<n.length?n[e+1].top-t:1);return n}var Op=1e-4;function BM(n,t){if(n.length===0)return!1;let e=Math.max(...n),i=n.length>1?Math.min(...n):-1/0;return t>e+Op*Math.abs(e)||t<i-Op*Math.abs(i)}function zM(n,t,e){let i=NM(n,t,e),s=UM(n,e),r=i.flatMap(o=>BM(n.limits,o.value)?[{...o,kind:"scale bad"}]:s.some(a=>Math.abs(a.top-o.top)<Yh/2)?[]:[o]);return FM([...s,...r])}function kM(n,t,e){return zM(n,t,e).map(({top:i,text:s,kind:r})=>{let o=Vt("span",r,s);return o.style.top=`${(100*i).toFixed(1)}%`,o})}function Zh({whole:n,ticks:t,title:e,unit:i}){let s=Vt("div","ground ticks");for(let r of t){let o=Vt("span","at",String(r));o.style.left=`${100*r/n}%`,s.append(o)}return s.append(Vt("span","axis",`${e}, ${i}`)),s}function Jh(n,t,e){let i=Vt("div",`area ${n}`),s=Vt("div","cursor"),r=a=>{let{left:c,width:l}=i.getBoundingClientRect();e(t*Math.min(1,Math.max(0,(a.clientX-c)/l)))};return i.addEventListener("pointerdown",a=>{i.setPointerCapture(a.pointerId),r(a)}),i.addEventListener("pointermove",a=>{a.buttons===1&&r(a)}),{area:i,cursor:s,show:a=>{s.style.left=`${100*a/t}%`}}}function GM(n,t){if(!n.reading)return()=>{};let e=Vt("output","reading");t.append(e);let i=n.sayFully??(s=>`${n.axis.format(s)}\xA0${n.axis.unit}`);return s=>{e.textContent=i(to(n.series[0],s))}}var VM=.12;function HM(n,t,e,{low:i,high:s}){if(n.series.length<2)return;let r=[...t.querySelectorAll(".curve")];t.addEventListener("pointermove",o=>{if(o.buttons!==0)return;let{left:a,top:c,width:l,height:h}=t.getBoundingClientRect(),d=e*(o.clientX-a)/l,u=s-(o.clientY-c)/h*(s-i),p=n.series.map(_=>Math.abs(to(_,d)-u)/(s-i)),f=p.reduce((_,g,m)=>g<p[_]?m:_,0);ss(p[f]<VM?f:null)}),t.addEventListener("pointerleave",()=>ss(null)),Xs(`chart of ${n.name}`,o=>{r.forEach((a,c)=>{a.classList.toggle("lit",c===o),a.classList.toggle("faded",o!==null&&c!==o)})})}function Bp(n,t){n.tabIndex=0,Ip(n,t),Xs(`row ${t}`,e=>n.classList.toggle("lit",e===t))}function zp(n,t,e){let i=Vt("figure","plot"),s=n.series.flatMap(d=>d.values).filter(Number.isFinite),r=Vt("figcaption","",`${n.name}, ${n.axis.unit}`);if(i.append(r),s.length===0)return i.append(Vt("p","more",n.none??"none")),{box:i,show:()=>{}};let o=GM(n,r),a=RM([...s,...n.floor??[],...n.from??[]],n.limits,n.far??TM),{area:c,cursor:l,show:h}=Jh("",t.length,e);return c.append(DM(n,t,a),...kM(n,s,a),l),HM(n,c,t.length,a),i.append(c,Zh(t)),{box:i,show:d=>{h(d),o(d)}}}function Kh(n,t){let e=0,i=n.length-1;for(;i-e>1;){let s=e+i>>1;n[s]<=t?e=s:i=s}return t-n[e]<n[i]-t?[e,i]:[i,e]}function to({at:n,values:t},e){let[i,s]=Kh(n,e),r=(e-n[i])/(n[s]-n[i]),o=t[i]+(t[s]-t[i])*Math.min(1,Math.max(0,r));return Number.isFinite(o)&&Number.isFinite(t[s])?o:t[i]}var as=n=>n.reduce((t,e)=>Number.isFinite(e)?Math.max(t,Math.abs(e)):t,0);var Gp=[{from:1e3,factor:.001,digits:3,name:"km"},{from:.1,factor:1,digits:3,name:"m"},{from:.001,factor:1e3,digits:2,name:"mm"},{from:0,factor:1e6,digits:1,name:"\xB5m"}],WM=[{from:1e4,factor:.001,digits:2,name:"kN"},{from:100,factor:1,digits:0,name:"N"},{from:0,factor:1,digits:1,name:"N"}],eu=(n,t)=>n.find(e=>Math.abs(t)>=e.from),XM=(n,t)=>n.toFixed(t).replace(/^-(?=[0.]*$)/,""),qs=({factor:n,digits:t,name:e})=>({unit:e,inUnit:i=>i*n,format:i=>Number.isFinite(i)?XM(i*n,t):"\u2013",brief:i=>`${Number((i*n).toPrecision(4))}\xA0${e}`}),ti=n=>qs(eu(Gp,n)),Vp=n=>t=>{let e=eu(Gp,t);return qs({...e,name:`${e.name}/${n}`})},Dc=Vp("s"),nu=Vp("s\xB2"),iu=()=>qs({factor:1,digits:2,name:"rad/s"}),_i=qs({factor:1,digits:2,name:"s"}),qM=6;function Nc(n){let t=n/qM,e=10**Math.floor(Math.log10(t)),i=e*[1,2,5,10].find(s=>s*e>=t);return Array.from({length:Math.floor(n/i)+1},(s,r)=>Number((r*i).toPrecision(6)))}var Hp=(n,t)=>`${_i.format(n)} of ${_i.format(t)}\xA0s`,Wp=n=>`${n<.01?"<\xA01":Math.round(100*n)}\xA0%`,$M={turn_speed:"angular speed",turn_acceleration:"angular acceleration",cable_speed:"cable speed",cable_acceleration:"cable acceleration"};function Oc({kind:n,cable:t}){let e=$M[n]??n;return t?`${e.replace(/^cable /,"")} of ${t}`:e}var su=n=>`${Oc(n)}, ${_i.format(n.from)} to ${_i.format(n.to)}\xA0s`,jh={stop:"stop",rounded:"rounded",outward:"rounded outward"};function Xp({waypoint:n,kind:t,deviation:e,time:i}){let s=e>0?`, ${$e(e)} off the path`:"";return`waypoint ${n} at ${_i.format(i)}\xA0s: ${jh[t]??t}${s}`}function qp(n){let t=i=>n.filter(s=>s.kind===i),e=Object.keys(jh).filter(i=>t(i).length>0).map(i=>{let s=Math.max(...t(i).map(({deviation:a})=>a)),r=s>0?` (at most ${$e(s)} off the path)`:"",o=i==="stop"&&t(i).length>1?"stops":jh[i];return`${t(i).length} ${o}${r}`});return e.length>0?`corners: ${e.join(", ")}`:""}var YM={jerk:["jerk","m/s\xB3"],cableAcceleration:["cable acceleration","m/s\xB2"],wrenchMargin:["wrench margin","N"]};function $p(n){let e=Object.entries(YM).filter(([i])=>n[i]!==null).map(([i,[s,r]])=>`${s} ${jp(n[i],r)}`);return e.length>0?`other limits: ${e.join(", ")}`:""}var eo=n=>qs(eu(WM,n));function Yp(n,t){let e=Math.min(6,Math.max(0,3-Math.floor(Math.log10(n||1))));return qs({factor:1,digits:e,name:t})}function In(n){if(n===0)return"0 m";let{unit:t,format:e}=ti(n);return`${e(n)}\xA0${t}`}var Lc=n=>`${Number(n.toPrecision(4))}\xA0m\xB3`;function Zp(n,t){let{unit:e,format:i}=ti(t);return`${i(n)} of ${i(t)}\xA0${e}`}function Jp(n,t){let{unit:e,format:i}=ti(t);return`(${n.map(i).join(", ")})\xA0${e}`}function $e(n){if(n>=1)return`${Number(n.toPrecision(3))}\xA0m`;let t=n*1e3;return t>=.1?`${Number(t.toPrecision(3))}\xA0mm`:`${Number((n*1e6).toPrecision(3))}\xA0\xB5m`}var no=1e-6;function $s(n){return Math.abs(n)<no?"touching":n<0?`${$e(-n)} deep`:$e(n)}function Kp({culprits:n,gap:t,required:e}){let i=n.join(" and ");return t<0&&t<e?`in collision here: ${i}, ${$e(-t)} deep`:e<=0?t<no?`nearest here: ${i} touch`:`nearest here: ${i}, ${$e(t)} apart`:`${t<e?"too near":"least room"} here: ${i}, ${$e(t)} apart, ${$e(e)} required`}var jp=(n,t)=>Number.isFinite(n)?`${Number(n.toPrecision(4))}\xA0${t}`:"\u2013";function Qp({measure:n,unit:t},e){if(!Number.isFinite(e))return`${n} margin: none here, a cable has no direction`;let i=e<0?"short of":"beyond";return`${n} margin: ${jp(Math.abs(e),t)} ${i} the demand`}function tm({count:n,every:t}){let e=`${n.toLocaleString("en")} edges`;return t>1?`search tree (${e}, 1 in ${t} drawn)`:`search tree (${e})`}function em({measure:n,unit:t,greatest:e}){return`${n} margin beyond the demand, 0 to ${Number(e.toPrecision(3))} ${t}; forces only: obstacles do not count`}function Qh([n,t]){let e=Lc(n);return e===Lc(t)?e:`${e.replace("\xA0m\xB3","")} to ${Lc(t)}`}var tu=n=>`${(100*n).toFixed(1)}\xA0%`,ZM={workspace:"leaving the workspace",wrench:"wrenches that the cables cannot provide","cable-length":"lengths of cables"};function nm({condition:n,share:t,names:e,most:i,pairs:s}){let r=ZM[n]??n.replace("-"," and "),o=s>1?`, ${e} most of it (${tu(i)})`:"";return`${r}: ${tu(t)}${s===1?`, ${e}`:o}`}function im(n,t){return n==="turns"?`during the turns through ${t} orientations`:`at ${n==="any"?"any":"every one"} of ${t} orientations`}function sm({volume:n,total:t}){let[e,i]=n.map(s=>tu(s/t));return e===i?e:`${e.replace("\xA0%","")} to ${i}`}function Uc({parts:n,apart:t,taken:e,orientations:i,validAt:s,...r}){let o=`${sm(r)} of where the platform is inside the workspace of the scene`,a=n===1?"in one part":`in ${n} parts${t?", start and goal in different ones":""}`,c=e.length>0?["What takes the rest away:",...e.map(nm)]:[],l=i>1?`, valid ${im(s,i)}`:"";return[`${o}, ${a}${l}`,...c]}function rm(n,t){let e=t?` \xB7 before: ${Qh(t)}`:"",i=n.taken.length>0?` \xB7 lost to ${nm(n.taken[0])}`:"";return`valid${n.orientations>1?` ${im(n.validAt,n.orientations)}`:""}: ${Qh(n.volume)} (${sm(n)})${e}${i}`}var Ys=n=>n.join(" and ");function om({volume:n,ofVolume:t,toGoal:e}){let i=t>0?Math.floor(100*n/t):0;return`The platform reaches ${i>=1?`at least ${i} % of its workspace`:"less than 1 % of its workspace"} (${Lc(n)}) and comes within ${In(e)} of the goal.`}function am({obstacle:n,cost:t}){return t===null?`without ${n}: still no path found`:`without ${n}: ${In(t)}`}var cm=({margin:n})=>`Proved: no path keeps a gap of more than ${$e(n)}. What can be reached is drawn as far as it is certain.`,JM={no_path:{verdict:"no path",tone:"bad",headline:"proved: there is none"},budget_spent:{verdict:"none found",tone:"warn",headline:"no path within the budget"},start_invalid:{verdict:"start not valid",tone:"bad",headline:""},goal_invalid:{verdict:"goal not valid",tone:"bad",headline:""}};function KM(n,t){return t>0?{verdict:"not valid",tone:"bad"}:{verdict:n==="solved"?"solved":"valid",tone:"good"}}var jM=1e-6,ru=({path:n,result:t})=>t?.cost??n.cost;function Fc(n,t){let e=ru(n);return e!==null&&Math.abs(e-t)>jM*t}function lm(n,t){let{path:e,trajectory:i,regions:s,violations:r,proved:o}=n;if(s?.shown&&!e)return{verdict:"regions",tone:"plain",headline:iw(s)};if(o)return{verdict:"workspace",tone:"plain",headline:Qh(o.volume)};if(!e)return{verdict:"scene",tone:"plain",headline:"no path"};if(e.waypoints.length===0)return JM[e.status]??{verdict:"no path",tone:"plain",headline:""};let a=!i&&Fc(n,t),{verdict:c,tone:l}=KM(a?null:e.status,r.length),h=`${In(i?.length??t)}`;return{verdict:c,tone:l,headline:i?`${h} in ${_i.format(i.duration)}\xA0s`:h}}function QM(n,t,e=0){let i=e>0?` through the via point${e===1?"":"s"}`:"",s=n/t-1;return s<1e-6?`the shortest path${i}`:`at most ${hm(s)} above the shortest${i}`}function hm(n){let t=100*n,e=10**(Math.floor(Math.log10(t))-1);return`${Number((Math.ceil(t/e-1e-9)*e).toPrecision(2))}\xA0%`}function tw(n,t){let e=n/t-1;return e<1e-6?"the straight line, so the shortest path":`${hm(e)} longer than the straight line`}function um({speed:n,acceleration:t,cableSpeed:e,cableAcceleration:i,turnSpeed:s,turnAcceleration:r,tensions:o}){let a=(l,h)=>`${Dc(l).brief(l)} and ${nu(h).brief(h)}`,c=[`at most ${a(n,t)}`,`cables ${a(e,i)}`];return s!==null&&c.push(`turns ${iu().brief(s)} and ${ew(r)}\xA0rad/s\xB2`),o&&c.push(`tensions ${o.map(l=>eo(l).brief(l)).join(" to ")}`),c.join(", ")}var ew=n=>`${Number(n.toPrecision(4))}`;function dm(n){if(n>=1)return`${Number(n.toPrecision(3))}\xA0s`;let t=1e3*n;return t<1?"<\xA01\xA0ms":`${Number(t.toPrecision(2))}\xA0ms`}var Bc=n=>`${ou(n)}${au(n)}`,nw={attachment:"where the end of that cable cannot be",position:"where the platform's origin cannot be"};function iw({space:n,meshes:t}){let i=`${t.every(({kind:s})=>s==="cable-obstacle")?"shadow":"forbidden region"}${t.length===1?"":"s"}`;return`${t.length} ${i} in the space of ${n}s: ${nw[n]??n}`}var kp={workspace:n=>`${n[0]??"platform"} leaves the workspace`,"cable-length":n=>`${n[0]??"a cable"} is too short or too long`,wrench:()=>"the cables cannot balance the platform",tilt:()=>"the platform tilts further than the scene allows","turning-axis":()=>"the platform turns about another axis than the scene allows"};function ou({kind:n,culprits:t,gap:e}){if(kp[n])return kp[n](t);let i=e>0?"comes too near":"meets";return t.length>=2?`${t[0]} ${i} ${t.slice(1).join(" and ")}`:[...t,n].join(": ")}function au({kind:n,gap:t,required:e}){return t===null?"":n==="workspace"?t<0?`, ${$e(-t)} outside`:"":n==="cable-length"?t<0?`, by ${$e(-t)}`:"":t<0?Math.abs(t)<no?"":`, ${$e(-t)} deep`:t>0?`, only ${$e(t)} apart, ${$e(e)} required`:""}function zc(n,t){let e=`${n} violation${n===1?"":"s"}`;return t<n?`${e} at ${t} place${t===1?"":"s"}`:e}function fm(n,t){let e=`after ${In(t)} (segment ${n.segment})`,i=n.time===null?e:`at ${_i.format(n.time)}\xA0s`;return`${ou(n)} ${i}${au(n)}`}var pm=n=>`${ou(n)}${au(n)}`;function kc(n,{bound:t=null,straight:e=0,via:i=0}){return t>0?QM(n,t,i):e>0?tw(n,e):""}var sw=6,rw=n=>`(${n.map(t=>Number(t.toFixed(3))).join(", ")})`,io=n=>document.getElementById(n),ow={obstacles:"nearest obstacle",robot:"within the robot"},aw=(n,t)=>Math.hypot(...n.slice(0,3).map((e,i)=>e-t[i]));function cw({verdict:n,tone:t,headline:e}){io("status").replaceChildren(Vt("span",`chip ${t}`,n)),e&&io("status").append(Vt("span",t==="plain"?"":"headline",e))}function lw({path:n,result:t,trajectory:e},i){if(!n||n.waypoints.length<2||e)return"";let s=n.turns?0:aw(n.waypoints[0],n.waypoints.at(-1));return kc(i,{bound:t?.lowerBound,straight:s,via:t?.via.length})}function hw(n,t){let{path:e,result:i,trajectory:s,proved:r}=n;if(r)return Uc(r);if(i?.reason){let c=i.nearestValid?[`a valid position near it: ${rw(i.nearestValid)}`]:[];return[...i.reasons.slice(0,sw).map(Bc),...c]}if(i?.openingBelow>0)return[`every path passes an opening narrower than ${$e(i.openingBelow)}`];if(s)return s.largest?[um(s.largest)]:[];if(!e||e.waypoints.length<2)return[];if(Fc(n,t))return[`changed since it was planned: its file states ${In(ru(n))}`];if(n.violations.length>0)return[];let o=[lw(n,t)],a=e.rawCost===null?"":In(e.rawCost);return a!==""&&a!==In(t)&&o.push(`${a} before it was made shorter`),o.filter(Boolean)}function uw({gap:n,required:t}){return n.reduce((e,i,s)=>i-t[s]<n[e]-t[e]?s:e,0)}function dw(n,t,e){let i=uw(n),[s,r]=[n.gap[i],n.required[i]],o=Vt("button","tightest");o.type="button",o.title="show this place";let a=r>0?`${$e(r)} required`:"",c=Vt("span",s<r?"value bad":"value",$s(s));return o.append(Vt("span","what",ow[n.of]??n.of),c,Vt("span","who",n.pairs[n.tightest[i]].join(" and ")),Vt("span","what",a)),o.addEventListener("click",()=>e(t[i])),o}function fw(n,t){let{path:e,result:i,trajectory:s}=n;if(!e||!s&&e.waypoints.length>0&&Fc(n,t))return"";let r=[e.planner];return i?.seed!==null&&i?.seed!==void 0&&r.push(`seed ${i.seed}`),i?.seconds>0&&r.push(dm(i.seconds)),r.filter(Boolean).join(" \xB7 ")}function mm(n,t,e){cw(lm(n,t)),io("remarks").replaceChildren(...hw(n,t).map(o=>Vt("p","",o)));let{motion:i}=n,s=(i?.approaches??[]).map(o=>dw(o,i.s,e)),r=Vt("p","more",`tightest on the whole ${n.trajectory?"motion":"path"}`);io("tightest").replaceChildren(...s.length>0?[r,...s]:[]),io("planner").textContent=fw(n,t)}var pw=Math.cos(8*Math.PI/180);function mw(n){let t=new C;return n.forEach((e,i)=>{let s=n[(i+1)%n.length];t.x+=(e.y-s.y)*(e.z+s.z-2*n[0].z),t.y+=(e.z-s.z)*(e.x+s.x-2*n[0].x),t.z+=(e.x-s.x)*(e.y+s.y-2*n[0].y)}),t.normalize()}function gm(n,t,e){for(let i=1;i+1<n.length;i+=1)for(let s of[n[0],n[i],n[i+1]])e.positions.push(s.x,s.y,s.z),e.normals.push(t.x,t.y,t.z)}function gw(n,t,e){n.forEach((i,s)=>{let r=n[(s+1)%n.length],o=i<r?`${i} ${r}`:`${r} ${i}`;e.has(o)||e.set(o,{i,j:r,normals:[]}),e.get(o).normals.push(t)})}var _w=({normals:n})=>n.length!==2||n[0].dot(n[1])<pw;function xw(n,t,e){let i=new Map;for(let s of n.faces){let r=s.map(a=>t[a]),o=mw(r);gm(r,o,e),n.faces.length===1&&gm(r.slice().reverse(),o.clone().negate(),e),gw(s,o,i)}for(let s of i.values())_w(s)&&e.edges.push(t[s.i],t[s.j])}function yw(n,t){n.length===1&&t.dots.push(n[0]);for(let e=1;e<n.length;e+=1)t.segments.push(n[e-1],n[e])}function bn(n,t){let e={positions:[],normals:[],edges:[],segments:[],dots:[]};for(let i of n){let s=i.vertices.map(r=>t(r));i.faces.length>0?xw(i,s,e):yw(s,e)}return e}function cu(n){let t=o=>n.flatMap(a=>a[o]),[e,i,s]=["positions","normals","edges"].map(t),r=n.flatMap(({positions:o,shade:a=1})=>o.map(()=>a));return{positions:e,normals:i,edges:s,shades:r,segments:t("segments"),dots:t("dots")}}function Ln(n){let t=new Ae;return t.setAttribute("position",new he(n.positions,3)),t.setAttribute("normal",new he(n.normals,3)),n.shades&&t.setAttribute("color",new he(n.shades,3)),t}function Zs(n){n.removeFromParent(),n.traverse(t=>{t.geometry?.dispose(),t.material?.dispose(),t.isInstancedMesh&&t.dispose()})}var vw=.78,_m=[1,.8,.92,.7];function Sw({min:n,max:t}){return[0,1,2,3,4,5,6,7].map(e=>new C(e&1?t.x:n.x,e&2?t.y:n.y,e&4?t.z:n.z))}function lu(n){let t=Sw(n),e=[];return t.forEach((i,s)=>{for(let r of[1,2,4])s&r||e.push(i,t[s|r])}),e}function bw(n,t){let e=n.getSize(new C),i=new yn({transparent:!0,opacity:.14,side:2,depthWrite:!1}),s=new ne(new fi(e.x,e.y),t.paint(i,"floor"));return n.getCenter(s.position).setZ(n.min.z),s.renderOrder=-1,s}function ym(n,t,e){if(!n.workspace)return[];let i=new ve(t.point(n.workspace.min),t.point(n.workspace.max)),s=Sn(lu(i));return e.paint(s.material,"workspace"),[s,bw(i,e)]}function xm(n,t){let e=new ze({transparent:!0,opacity:vw,vertexColors:!0,side:ke,forceSinglePass:!0,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1,...t});return n.paint(e,"obstacle")}function Mw(n){let t=new ne(void 0,xm(n,{colorWrite:!1})),e=new ne(void 0,xm(n,{depthWrite:!1}));return t.renderOrder=1,e.renderOrder=2,[t,e]}function Gc(n,...t){t[0].geometry.dispose();for(let e of t)e.geometry=n}function vm(n,t,e){let i=n.obstacles.map(({parts:m},y)=>({...bn(m,E=>t.point(E)),shade:_m[y%_m.length]})),[s,r]=Mw(e),o=Sn([],new je({transparent:!0})),a=pe([],{linewidth:3}),c=dn([],8);o.renderOrder=3,e.paint(o.material,"obstacleEdge"),e.paint(a.material,"obstacle"),e.paint(c.material,"obstacle");function l(m){let y=cu(i.filter((E,b)=>!m.has(b)));Gc(Ln(y),s,r),Gc(is(y.edges),o),Gc(Ec(y.segments),a),Gc(is(y.dots),c),a.visible=y.segments.length>0,c.visible=y.dots.length>0}let h=[s,r,o,a,c],d=new ee,u=new Map,p=new Set;function f(m){let y=i[m],E=Ln(cu([y])),b=new ee,T=[E,E,is(y.edges),Ec(y.segments),is(y.dots)];h.forEach((w,x)=>{let M=w.clone();M.geometry=T[x],M.visible=x<3||[y.segments,y.dots][x-3].length>0,b.add(M)}),u.set(m,b),d.add(b),_(p)}function _(m){p=m,l(new Set([...m,...u.keys()]));for(let[y,E]of u)E.visible=!m.has(y)}function g(m,y){u.has(m)||f(m),u.get(m).position.copy(y)}return l(new Set),{objects:i.length>0?[...h,d]:[],show:_,move:g}}var Hn=([n,t,e,i])=>new we(t,e,i,n).normalize(),Sm=(n,t)=>bn(n.platform,e=>t.vector(e));function ww(n,t){let e=new ze({side:ke,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1});return new ne(Ln(n),t.paint(e,"platform"))}function bm(n,t){let e=new ee,i=Sn(n.edges);t.paint(i.material,"platformEdge");let s=pe(n.segments,{linewidth:4});t.paint(s.material,"platform");let r=dn([...n.dots,new C],8);return t.paint(r.material,"platform"),e.add(ww(n,t),i,s,r),e}function Ew(){return new ze({transparent:!0,opacity:.3,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:2,polygonOffsetUnits:2})}function Vc(n,t,e,i="ghost"){let s=new ee;s.quaternion.copy(Hn(t));let r=pe([...n.edges,...n.segments],{linewidth:1.5}),o=dn([...n.dots,new C],9),a=new ne(Ln(n),Ew());a.renderOrder=4;for(let c of[r,o,a])e.paint(c.material,i);return s.add(a,r,o),s}function Mm(n,t,e){if(n.cables.length===0)return[];let i=n.cables.map(o=>t.point(o.outlet)),s=dn(i,8),r=pe(lu(new ve().setFromPoints(i)),{linewidth:2});return e.paint(s.material,"outlet"),e.paint(r.material,"frame"),[s,r]}var wm=1e9,Js=n=>n.map(t=>Math.round(t*wm)/wm),Tm=(n,t)=>Js(n.map((e,i)=>e+t[i])),Cm=(n,t)=>n.map((e,i)=>e-t[i]),Rm=Object.freeze([0,0,0]),ei=["start","goal"],so=n=>n.position??Rm,Hc=n=>n.obstacles??[],Wc=(n,t)=>n.name??`obstacle ${t}`,hu=new WeakMap;function Pm({obstacles:n}){if(!n)return new Map;if(!hu.has(n)){let t=new Map;n.forEach((e,i)=>{let s=Wc(e,i);t.has(s)?t.get(s).push(e):t.set(s,[e])}),hu.set(n,t)}return hu.get(n)}var ro=(n,t)=>Pm(n).get(t)??[],oo=n=>[...Pm(n).keys()],uu=(n,t)=>ro(n,t).length>0,Im=(n,t)=>so(ro(n,t)[0]);function Aw(n,t,e){let i=(s,r)=>Wc(s,r)===t?{...s,position:Tm(so(s),e)}:s;return{...n,obstacles:Hc(n).map(i)}}var ao=(n,t,e)=>({...n,query:{...n.query,[t]:Js(e)}});function Tw(n,t,e){let i=n.robot.cables.map((s,r)=>r===t?{...s,outlet:Js(e)}:s);return{...n,robot:{...n.robot,cables:i}}}function Cw(n){let t=new Set(oo(n));for(let e=1;;e+=1)if(!t.has(`box ${e}`))return`box ${e}`}function Lm(n,t,e){let i=Cw(n),s={name:i,box:Js(t),position:Js(e)};return{scene:{...n,obstacles:[...Hc(n),s]},name:i}}var Em=(n,t)=>n?.filter(e=>!e.includes(t));function Dm(n,t){let{ignore:e,touch:i,clearances:s}=n,r=s?.pairs?.filter(({between:a})=>!a.includes(t)),o=Hc(n).map((a,c)=>({...a,name:Wc(a,c)}));return{...n,obstacles:o.filter(a=>a.name!==t),...e&&{ignore:Em(e,t)},...i&&{touch:Em(i,t)},...r&&{clearances:{...s,pairs:r}}}}var Nm=(n,t)=>({...n,clearance:t}),Xc=n=>(n.orientations??[]).map(({name:t})=>t);function Om(n,t){let{orientation:e,...i}=n.query??{};return{...n,query:t===null?i:{...i,orientation:t}}}function du(n,t){let e=ro(n,t);return e.length===1&&e[0].box?e[0].box:null}function Um(n,t,e){let i=(s,r)=>Wc(s,r)===t?{...s,box:Js(e)}:s;return{...n,obstacles:Hc(n).map(i)}}var Ks=n=>ei.filter(t=>!n.query?.[t]);function qc(n,t){return[...ei.filter(i=>n.query?.[i]).map(i=>({kind:"end",id:i,name:i})),...oo(n).map(i=>({kind:"obstacle",id:i,name:i})),...n.robot.cables.map((i,s)=>({kind:"outlet",id:s,name:`outlet of ${t[s]?.name??`cable ${s}`}`}))]}var Wn=(n,t)=>n===t||!!(n&&t)&&n.kind===t.kind&&n.id===t.id;function Mn(n,{kind:t,id:e}){return t==="end"?n.query?.[e]??null:t==="outlet"?n.robot.cables[e]?.outlet??null:uu(n,e)?Im(n,e):null}function js(n,{kind:t,id:e},i){return t==="end"?ao(n,e,i):t==="outlet"?Tw(n,e,i):Aw(n,e,Cm(i,Im(n,e)))}var Rw=[0,1,2,3,4,5,6,7],Pw=[[0,4,6,2],[1,3,7,5],[0,1,5,4],[2,6,7,3],[0,2,3,1],[4,5,7,6]];function Iw({rpy:n,rpy_degrees:t,quaternion:e}){if(e)return Hn(e);let[i,s,r]=n??(t??Rm).map(o=>o*Math.PI/180);return new we().setFromEuler(new Bn(i,s,r,"ZYX"))}function Am(n){let[t,e]=[Iw(n),so(n)],i=r=>new C(...n.box.map((o,a)=>(r&1<<a?.5:-.5)*o));return{vertices:Rw.map(r=>Tm(e,i(r).applyQuaternion(t).toArray())),faces:Pw}}var Lw=(n,t)=>({...n,vertices:n.vertices.map(e=>e.map((i,s)=>i+t[s]))});function Dw(n,t,{shown:e,drawn:i}){let[s]=ro(n,t),[r]=ro(e,t),o=i.get(t);if(!o||!r)return{name:t,parts:s.box?[Am(s)]:[]};if(String(r.box)!==String(s.box))return{name:t,parts:[Am(s)]};let a=Cm(so(s),so(r));return a.every(c=>c===0)?o:{name:t,parts:o.parts.map(c=>Lw(c,a))}}function $c(n,t,e){let i={shown:e,drawn:new Map((t.obstacles??[]).map(r=>[r.name,r]))},s=(t.cables??[]).map((r,o)=>({...r,outlet:n.robot.cables[o]?.outlet??r.outlet}));return{...t,cables:s,obstacles:oo(n).map(r=>Dw(n,r,i)),start:n.query?.start??null,goal:n.query?.goal??null,path:null,no_path:null,motion:null,regions:null,feasible:null,violations:[]}}var fu=78,zm=16,Ow={hover:2.5,selected:3.5,bad:3.5},Fm={hover:"focus",selected:"focus",bad:"violation"},Uw={hover:13,selected:15,bad:15},Fw=["#d55e00","#009e73","#2b8fd0"],zi=[new C(1,0,0),new C(0,1,0),new C(0,0,1)],km=n=>zi[n];function pu(n,t){return n.renderOrder=t,n.material.depthTest=!1,n.material.transparent=!0,n}function Bw(n){let t=new ee,e=pe([zi[n].clone().multiplyScalar(zm/fu),zi[n].clone().multiplyScalar(.8)],{linewidth:3}),i=new ne(new Tr(.07,.2,16),new yn);i.position.copy(zi[n]).multiplyScalar(.9),i.quaternion.copy(new we().setFromUnitVectors(zi[1],zi[n]));for(let s of[e,i])s.material.color.set(Fw[n]);return t.add(pu(e,30),pu(i,31)),t}function zw(n,t,e){if(t.isOrthographicCamera)return(t.top-t.bottom)/t.zoom/e;let i=n.clone().sub(t.position).dot(t.getWorldDirection(new C));return 2*Math.max(i,1e-6)*Math.tan(t.fov*Math.PI/360)/e}function Gm(){let n=new ee;return n.add(...zi.map((t,e)=>Bw(e))),n.visible=!1,{group:n,fit:(t,e,i)=>{n.position.copy(t),n.scale.setScalar(fu*zw(t,e,i))},only:t=>n.children.forEach((e,i)=>{e.visible=t===null||t===i}),ends:()=>zi.map(t=>[zm/fu,1].map(e=>t.clone().multiplyScalar(e*n.scale.x).add(n.position)))}}function Vm({kind:n,id:t},{model:e,frame:i,place:s}){if(n==="outlet")return null;if(n==="end"){let a=Hn(t==="start"?e.startOrientation:e.goalOrientation);return bn(e.platform,c=>i.vector(c).applyQuaternion(a))}let r=e.obstacles.find(({name:a})=>a===t),o=i.point(s);return r?bn(r.parts,a=>i.point(a).sub(o)):null}function Hm(n,t,e,i){let s=i.createPainter(),r=new ee,o=t?[...t.edges,...t.segments]:[];if(o.length>0){let c=pe(o,{linewidth:Ow[e]});s.paint(c.material,Fm[e]),c.renderOrder=8,r.add(c)}else{let c=pu(dn([new C],Uw[e]),9);s.paint(c.material,Fm[e]),r.add(c)}return{thing:n,group:r,remove:()=>{s.release(),Zs(r)}}}var Bm=new Or,kw=new yn({side:ke});function Wm(n){return new ne(Ln(n),kw)}function mu({x:n,y:t},e,{clientWidth:i,clientHeight:s}){return Bm.setFromCamera(new Ut(2*n/i-1,1-2*t/s),e),Bm}function Yc(n,t,{clientWidth:e,clientHeight:i}){let s=n.clone().project(t);return Math.abs(s.z)>1?null:{x:(s.x+1)/2*e,y:(1-s.y)/2*i}}function Xm(n,t,e){let[i,s]=[e.x-t.x,e.y-t.y],r=Math.min(1,Math.max(0,((n.x-t.x)*i+(n.y-t.y)*s)/(i*i+s*s||1)));return Math.hypot(n.x-t.x-r*i,n.y-t.y-r*s)}var Gw=.12,Vw=new C(0,0,1),qm=.01;function Hw(n,t,{ray:e}){let i=n.clone().sub(e.origin),s=t.dot(e.direction),r=1-s*s;return r<1e-4?null:(s*i.dot(e.direction)-i.dot(t))/r}function Ww(n,{ray:t},e){let i=e.getWorldDirection(new C),r=Math.abs(t.direction.z)<Gw?i.setZ(0).normalize():Vw,o=t.intersectPlane(new He().setFromNormalAndCoplanarPoint(r,n),new C);return o?o.sub(n).setZ(0):null}function Xw(n,t,e){let i=Hw(t,n,e);return i===null?null:n.clone().multiplyScalar(i)}var qw=(n,t,e,i)=>n==="floor"?Ww(t,e,i):Xw(km(n),t,e),$w=n=>Math.round(Math.round(n/qm)*qm*1e9)/1e9;function $m({from:n,grabbed:t,axis:e,frame:i,limits:s}){let r=null,o=n,a=t.clone(),c=n,l=u=>e??(u?2:"floor");function h(u){a.add(i.vector(c.map((p,f)=>p-o[f]))),o=c,r=u}function d(u,p,{vertical:f,free:_}){let g=l(f);g!==r&&h(g);let m=qw(r,a,u,p);if(!m)return c;let y=m.toArray().map(b=>b/i.scale);c=o.map((b,T)=>Math.min(s.max[T],Math.max(s.min[T],b+y[T])));let E=b=>r==="floor"?b<2:b===r;return c.map((b,T)=>E(T)&&!_?$w(b):b)}return{from:n,to:d}}var Yw=new ve(new C().setScalar(-1/0),new C().setScalar(1/0)),Ym={mouse:{arrow:8,dot:11},touch:{arrow:20,dot:24}},Zm=4,Zw=n=>n.pointerType==="touch"?Ym.touch:Ym.mouse;function Jm({stage:n,theme:t},e,i){let{canvas:s,controls:r}=n,o=s.parentElement,a=Gm(),c={hover:[],selected:[],bad:[]},l=new Map,h=new Map,d=!1,u=null,p=null,f=null,_=s.clientHeight;n.scene.add(a.group);let g=({kind:$,id:R})=>`${$} ${R}`,m=$=>e.frame().point(e.placeOf($)),y=$=>Vm($,{model:e.model(),frame:e.frame(),place:e.shownAt($)});function E($){let R=g($);if(!l.has(R)){let it=y($);l.set(R,it&&it.positions.length>0?Wm(it):null)}let z=l.get(R);return z?.position.copy(m($)),z?.updateMatrixWorld(),z}function b(){if(h.size===0)for(let{name:$,parts:R}of e.model().obstacles)h.set($,new ve().setFromPoints(R.flatMap(({vertices:z})=>z.map(it=>e.frame().point(it)))));return h}let T=($,{ray:R})=>$.kind!=="obstacle"||R.intersectsBox(b().get($.id)??Yw),w=$=>{let{left:R,top:z}=s.getBoundingClientRect();return{x:$.clientX-R,y:$.clientY-z}};function x($,{arrow:R}){if(!a.group.visible)return null;let z=a.ends().flatMap(([it,ht],rt)=>{let[Ct,re]=[it,ht].map(Kt=>Yc(Kt,n.camera,s)),It=Ct&&re?Xm($,Ct,re):1/0;return It<=R?[{axis:rt,distance:It}]:[]});return z.sort((it,ht)=>it.distance-ht.distance),z.length>0?{thing:u,axis:z[0].axis,at:m(u)}:null}function M($,R){let z=mu(R,n.camera,s);return $.filter(ht=>T(ht,z)).flatMap(ht=>{let[rt]=[E(ht)].filter(Boolean).flatMap(Ct=>z.intersectObject(Ct));return rt?[{thing:ht,axis:null,at:rt.point,distance:rt.distance}]:[]}).sort((ht,rt)=>ht.distance-rt.distance)[0]??null}function D($,R,{dot:z}){return $.filter(({kind:ht})=>ht!=="obstacle").flatMap(ht=>{let rt=m(ht),Ct=Yc(rt,n.camera,s),re=Ct?Math.hypot(Ct.x-R.x,Ct.y-R.y):1/0;return re<=z?[{thing:ht,axis:null,at:rt,distance:re}]:[]}).sort((ht,rt)=>ht.distance-rt.distance)[0]??null}function P($){let R=w($),z=Zw($),it=e.things().filter(e.isVisible);return x(R,z)??D(it,R,z)??M(it,R)}function O($,R){if(!(c[$].length===0&&R.length===0)){for(let z of c[$])z.remove();c[$]=R.map(z=>{let it=Hm(z,y(z),$,t);return n.scene.add(it.group),it}),B()}}function B(){for(let{thing:$,group:R}of Object.values(c).flat())R.position.copy(m($));q(),n.invalidate()}function q(){a.group.visible=d&&u!==null,a.group.visible&&(n.camera.updateMatrixWorld(),a.fit(m(u),n.camera,_))}function I($){Wn(c.hover[0]?.thing,$)||O("hover",$?[$]:[])}function V($){Wn(u,$)||(u=$,O("selected",$?[$]:[]),I(null),i.select($))}function Y($,{thing:R,axis:z,at:it}){let ht=e.placeOf(R);p={...$m({from:ht,grabbed:it.clone(),axis:z,frame:e.frame(),limits:e.limits()}),id:$.pointerId,thing:R,axis:z,start:w($),moving:!1},r.enabled=!1,s.setPointerCapture($.pointerId),s.style.cursor="grabbing",s.dispatchEvent(new PointerEvent("pointerleave")),z!==null&&a.only(z),n.invalidate()}function W(){let{id:$}=p;p=null,r.enabled=!0,s.hasPointerCapture($)&&s.releasePointerCapture($),s.style.cursor="",a.only(null),n.invalidate()}function st($){if(!d||(p&&$.stopPropagation(),p||$.button!==0))return;let R=P($);f={id:$.pointerId,at:w($),hit:R},R&&($.pointerType!=="touch"||R.axis!==null||Wn(R.thing,u))&&($.stopPropagation(),$.preventDefault(),s.focus({preventScroll:!0,focusVisible:!1}),V(R.thing),Y($,R))}function F($){let R=w($);if(!p.moving&&Math.hypot(R.x-p.start.x,R.y-p.start.y)<Zm)return;p.moving||i.drag(p.thing,p.from,"begin"),p.moving=!0;let z=mu(R,n.camera,s);i.drag(p.thing,p.to(z,n.camera,{vertical:$.shiftKey,free:$.altKey}),"move")}function X($){if(d){if(p&&$.stopPropagation(),p?.id===$.pointerId)F($);else if(!p&&$.pointerType!=="touch"&&$.buttons===0){let R=P($);I(R&&R.axis===null&&!Wn(R.thing,u)?R.thing:null),s.style.cursor=R?"grab":""}}}function j($){if(p?.id===$.pointerId){let{thing:R,moving:z}=p;W(),z&&i.drag(R,null,"end")}else if(d&&f?.id===$.pointerId){let{x:R,y:z}=w($);Math.hypot(R-f.at.x,z-f.at.y)<2*Zm&&V(f.hit?.thing??null)}f=null}function ot(){if(!p)return!1;let{thing:$,moving:R,from:z}=p;return W(),R&&i.drag($,z,"cancel"),!0}return o.addEventListener("pointerdown",st,{capture:!0}),o.addEventListener("pointermove",X,{capture:!0}),o.addEventListener("pointerup",j,{capture:!0}),o.addEventListener("pointercancel",ot,{capture:!0}),o.addEventListener("pointerleave",()=>I(null)),r.addEventListener("change",q),new ResizeObserver(()=>{_=s.clientHeight,q()}).observe(s),{get selected(){return u},get dragging(){return p!==null&&p.moving},select:V,cancel:ot,place:B,setActive:$=>{d=$,$||(ot(),V(null),I(null)),s.style.cursor="",q(),n.invalidate()},setBad:$=>O("bad",$),refresh:()=>{for(let z of l.values())z?.geometry.dispose();l.clear(),h.clear();let $=e.things(),R=z=>$.some(it=>Wn(it,z));for(let z of Object.keys(c))O(z,c[z].map(({thing:it})=>it).filter(R));u&&!R(u)&&V(null)},where:$=>{let R=Yc(m($),n.camera,s),{left:z,top:it}=s.getBoundingClientRect();return R&&{x:R.x+z,y:R.y+it}}}}function Km(n){let t=[],e=n,i=[];function s(r,o){return r.length===0?!1:(o.push(e),e=r.pop(),!0)}return{get present(){return e},get canUndo(){return t.length>0},get canRedo(){return i.length>0},push:r=>{t=[...t,e].slice(-200),e=r,i=[]},replace:r=>{e=r},undo:()=>s(t,i),redo:()=>s(i,t)}}var Qm=100,Jw=8,xu="(max-width: 899px)",Et=n=>document.getElementById(n);function ge(n,t,e){let i=document.createElement(n);return t&&(i.className=t),e!==void 0&&(i.textContent=e),i}function tg(n){Et("title").textContent=n.title,Et("title").title=n.title}function Kw(n){let t=n.slice(0,Jw).map((i,s)=>{let r=ge("li");return r.append(ge("span",`swatch solid of-${Ws(s)}`),ge("span","",Ys(i))),r}),e=n.length-t.length;return e>0?[...t,ge("li","more",`and ${e} more`)]:t}function eg(n,t){if(Et("no-path").hidden=!n,!n)return;Et("closed-by").replaceChildren(...Kw(n.culprits)),Et("reached").textContent=om(n),Et("proved").textContent=cm(n);let e=n.without.map(r=>{let o=ge("button","",am(r));return o.type="button",o.disabled=r.cost===null,o.setAttribute("aria-pressed","false"),o.addEventListener("click",()=>i(o,r.obstacle)),o}),i=(r,o)=>{let a=r.getAttribute("aria-pressed")!=="true";for(let c of e)c.setAttribute("aria-pressed",String(a&&c===r));t(a?o:null)},s=ge("p","","No obstacle has a part in it: leaving one out does not help.");Et("remedies").replaceChildren(...e.length>0?e:[s])}var ng=()=>[...Et("tabs").querySelectorAll("button")];function jm(n){document.body.dataset.tab=n;for(let t of ng())t.setAttribute("aria-pressed",String(t.dataset.tab===n));Et("sheet").dispatchEvent(new Event("fold"))}function ig(){let n=window.matchMedia(xu),t=()=>{for(let e of["details","plots"])Et(e).open=!0};for(let e of ng()){let{tab:i}=e.dataset;e.addEventListener("click",()=>jm(document.body.dataset.tab===i?"":i))}jm("result"),n.addEventListener("change",t),t()}var yu=()=>!Et("plots").hidden;function sg(){window.matchMedia(xu).matches||(Et("plots").open=!1)}function rg(){let n=()=>[...Et("legend").querySelectorAll("details")],t=s=>s.querySelector("summary").textContent,e=new Map(n().map(s=>[t(s),s.open])),i=Et("panel").scrollTop;return Et("legend").replaceChildren(),()=>{for(let s of n())s.open=e.get(t(s))??s.open;i>0&&(Et("panel").scrollTop=i)}}function og(n,t,e){let i=ge("details","fold");return i.open=t,i.append(ge("summary","",n)),e.after(i),i}function ag(n){let t=ge("div","fold");return n.after(t),t}function cg(n,t){t.after(ge("p","more fold",n))}function lg(n,t){let e=ge("div","row");for(let[i,s]of[["all",!0],["none",!1]]){let r=ge("button","",i);r.type="button",r.addEventListener("click",()=>{for(let o of t)o.visible=s}),e.append(r)}n.querySelector("summary").after(e)}function vu(n){let t=[...Et("legend").children].find(i=>i.dataset.title===n);if(t)return t;let e=ge("section","legend-group");return e.dataset.title=n,e.append(ge("h3","",n)),Et("legend").append(e),e}function hg(n,t,e,i){let s=ge("label","legend-row"),r=ge("input");return r.type="checkbox",r.checked=e.visible,r.addEventListener("change",()=>{e.visible=r.checked}),s.append(r,ge("span",`swatch ${t}`),ge("span","legend-name",n)),i.append(s),{element:s,tick:a=>{r.checked=a}}}function jw({place:n,members:t},e){let i=ge("li"),s=ge("button","violation",fm(t[0],n));if(s.type="button",s.addEventListener("click",()=>e(n)),i.append(s),t.length===1)return i;let r=ge("details","same-place"),o=ge("ul"),a=t.slice(1,Qm);return o.append(...a.map(c=>ge("li","",Bc(c)))),a.length<t.length-1&&o.append(ge("li","more",`and ${t.length-1-a.length} more`)),r.append(ge("summary","",`and ${t.length-1} more at this place`),o),i.append(r),i}var Qw=1e-4;function tE(n,t,e){let i=[];for(let s of n){let r=t(s),o=i.at(-1);o&&Math.abs(r-o.place)<=Qw*e?o.members.push(s):i.push({place:r,members:[s]})}return i}function ug(n,{placeOf:t,length:e},i){Et("violations").hidden=n.length===0;let s=tE(n,t,e),r=s.slice(0,Qm).map(a=>jw(a,i));Et("violation-list").replaceChildren(...r),Et("violation-count").textContent=zc(n.length,s.length);let o=s.length-r.length;o>0&&Et("violation-list").append(ge("li","more",`and ${o} more`))}function Su(){let n=r=>Et(r).getBoundingClientRect().height>0?Et(r).getBoundingClientRect().top:window.innerHeight,t=Math.max(...["tools","edit"].map(r=>Et(r)?.getBoundingClientRect().bottom??0));if(window.matchMedia(xu).matches){let r=Math.min(...["bar","tabs"].map(n));return{left:0,right:0,top:t,bottom:window.innerHeight-r}}let e=Et("panel").getBoundingClientRect(),i=Et("plots").getBoundingClientRect(),s=Et("plots").open&&i.width>0?window.innerWidth-i.left:0;return{left:e.right,right:s,top:t,bottom:window.innerHeight-n("bar")}}function dg(n){Et("corner").hidden=!1,Et("grid-step").textContent=n===null?"":`grid ${ti(n).brief(n)}`}function bu(n){Et("message").textContent=n,Et("message").hidden=!1}var _u={ArrowRight:.01,ArrowUp:.01,ArrowLeft:-.01,ArrowDown:-.01,PageUp:.1,PageDown:-.1,Home:-1,End:1};function fg(n,t,e){e.preventDefault(),t.pause(),t.setDistance(t.distance()+n*t.length())}function eE(n,t,e){n.addEventListener("input",()=>{t.pause(),t.setDistance(Number(n.value))},e),n.addEventListener("keydown",i=>{let s=_u[i.key];s!==void 0&&fg(s,t,i)},e)}function pg(n,t,e){let i=()=>n.setSpeed(Number(Et("speed").value));eE(Et("slider"),n,{signal:e}),Et("play").addEventListener("click",n.toggle,{signal:e}),Et("speed").addEventListener("change",i,{signal:e}),i(),t&&(Et("slider").setAttribute("aria-label","time, s"),Et("speed").title="speed of the playback; 1\xD7 is real time"),Mu(n.length())}function Mu(n){Et("slider").max=String(n),Et("transport").hidden=n===0}function wu(n,t){let e=n.filter(i=>i>0&&i<t).map(i=>{let s=ge("span","stop");return s.style.setProperty("--at",String(i/t)),s});Et("stops").replaceChildren(...e)}function mg(n,t,e){t!==0&&(Et("slider").value=String(n),Et("slider").setAttribute("aria-valuetext",e),Et("distance").textContent=e)}function gg(n,t){Et("position").textContent=`platform at ${Jp(n,t)}`}function Eu(n){Et("play").setAttribute("aria-label",n?"pause":"play"),Et("play").dataset.playing=String(n)}function _g(){let n=Et("help");n.open?n.close():n.showModal()}var gu=["","x","y","z"];function xg({look:n,cut:t,save:e,toggleLook:i,resize:s}){for(let o of["x","y","z"])Et(`view-${o}`).addEventListener("click",()=>n(o));Et("reset").addEventListener("click",()=>n()),Et("save").addEventListener("click",e),Et("look").addEventListener("click",i);for(let[o,a]of[["plots","toggle"],["sheet","fold"]])Et(o).addEventListener(a,s);Et("keys").addEventListener("click",_g);let r=()=>{Et("section-at").disabled=Et("section").value==="",t(Et("section").value,Number(Et("section-at").value))};Et("section").addEventListener("change",r),Et("section-at").addEventListener("input",r),Et("tools").hidden=!1}function nE(){let n=(gu.indexOf(Et("section").value)+1)%gu.length;Et("section").value=gu[n],Et("section").dispatchEvent(new Event("change"))}var Au=(n,t)=>n instanceof Element&&n.closest(t)!==null,iE=n=>Au(n,"button, summary, select, input[type=checkbox]"),sE=n=>Au(n,"canvas, select, input[type=range]"),rE={1:({look:n})=>n("x"),2:({look:n})=>n("y"),3:({look:n})=>n("z"),r:({look:n})=>n(),s:nE,d:({toggleLook:n})=>n(),p:({save:n})=>n(),"?":_g};function yg(n,t,e){window.addEventListener("keydown",i=>{i.ctrlKey||i.metaKey||i.altKey||i.defaultPrevented||(_u[i.key]!==void 0&&!sE(i.target)&&fg(_u[i.key],n,i),!i.repeat&&(t.look&&!Au(i.target,"select")&&rE[i.key.toLowerCase()]?.(t),!(i.key!==" "||iE(i.target))&&(i.preventDefault(),n.toggle())))},{signal:e})}var aE=["violations","nearest","swept","feasible","regions","reachable","walls","culprits","nearestReachable","detours","searchTree","rawPath"];function cE(n,t){n.traverse(({material:e})=>{e&&(e.transparent||Object.assign(e,{transparent:!0,needsUpdate:!0}),e.opacity=t?.3:1)})}function vg(n,{outdated:t,dimmed:e}){if(document.documentElement.classList.toggle("outdated",t),!n)return;let{contents:i}=n;for(let s of aE)for(let r of i[s]??[])r.traverse(({layers:o})=>o.set(t?31:0));for(let s of i.finalPath)cE(s,e);n.outdated=t}function lE({drawn:n,frame:t,model:e},i,s){let r=e.obstacles.findIndex(c=>c.name===i);if(r<0)return;let o=t.vector(s);n.obstacles.move(r,o);let a=n.anchors.get(`obstacle ${i}`);a&&a.at.copy(a.first).add(o)}function hE({drawn:n,frame:t,model:e},i,s){let[r]=n.contents.outlets,o=t.point(s);n.cables.moveOutlet(i,o),o.toArray(r.geometry.attributes.position.array,3*i),r.geometry.attributes.position.needsUpdate=!0,n.anchors.get(`cable ${e.cables[i]?.name}`)?.at.copy(o)}function Sg(n,{kind:t,id:e},i,s){if(t==="obstacle")lE(n,e,s.map((r,o)=>r-i[o]));else if(t==="outlet")hE(n,e,s);else{let r=n.drawn.ghosts.find(({name:o})=>o===e);r&&n.frame.point(s,r.position)}}var uE=Array.from({length:94},(n,t)=>String.fromCharCode(33+t)).filter(n=>!`"$&'/<\\{}`.includes(n)).join("");function bg(n){let t=new Uint8Array(128);for(let s=0;s<85;s+=1)t[uE.charCodeAt(s)]=s;let e=Math.floor(4*n.length/5),i=new Uint8Array(e);for(let s=0,r=0;s<n.length;s+=5,r+=4){let o=0;for(let a=0;a<5;a+=1)o=85*o+(s+a<n.length?t[n.charCodeAt(s+a)]:84);for(let a=3;a>=0;a-=1)r+a<e&&(i[r+a]=o%256),o=Math.floor(o/256)}return i}var dE=[["WebAssembly","WebAssembly"],["Worker","web workers"],["DecompressionStream","decompression of streams"]];function Cu(n=window){let t=dE.filter(([e])=>typeof n[e]>"u").map(([,e])=>e);return t.length===0?null:`Editing is not available: this browser, or this private window, lacks ${t.join(" and ")}.`}var Mg=n=>document.getElementById(n)?.textContent??"";async function fE(n){let t=new Blob([bg(n.trim())]).stream().pipeThrough(new DecompressionStream("deflate-raw"));return new Response(t).arrayBuffer()}var pE=async()=>WebAssembly.compile(await fE(Mg("cdpr-module"))),mE=()=>URL.createObjectURL(new Blob([Mg("cdpr-worker")],{type:"text/javascript"}));function Tu(n){let t=null,e=null,i=null,s=0;function r(f,_){_?.error?f.reject(Object.assign(new Error(_.error.message),{key:_.error.key})):f.resolve(_)}function o(){e=i,i=null,e&&t.postMessage({id:e.id,request:e.request})}function a({data:f}){if(!e||f.id!==e.id)return;if(f.improved){e.onImproved?.(f.improved);return}let _=e;f.answer?.error?.fatal?l():o(),r(_,f.answer)}function c(f){let _=e;d(),_?.reject(new Error(f||"the planner has stopped"))}function l(){t.terminate(),t=null,i?(h(),o()):e=null}function h(){t=n(),t.addEventListener("message",a),t.addEventListener("error",f=>{f.preventDefault(),c(f.message)})}function d(){t?.terminate(),t=null,i?.resolve(null),e=null,i=null}function u(){if(!e)return;let f=e;d(),f.resolve(null)}function p(f,_){return new Promise((g,m)=>{s+=1,i?.resolve(null),i={id:s,request:f,onImproved:_,resolve:g,reject:m},t||h(),e||o()})}return{ask:p,cancel:u,busy:()=>e!==null}}function wg(){let n=null,t=null;async function e(){let i=Cu();if(i)throw new Error(i);let s=await pE();n=mE();let r=()=>{let o=new Worker(n);return o.postMessage({module:s}),o};return{plan:Tu(r),place:Tu(r),divide:Tu(r)}}return{ready:()=>(t??(t=e()),t)}}var Ag={cost:null,waypoints:[],milliseconds:0},co={status:"superseded",...Ag},gE={status:"unasked",...Ag},_E={planner:"rrt-connect",budget_ms:40,proof:!1},Eg=60,xE=200,yE=24,vE=(n,t)=>Math.hypot(...n.map((e,i)=>e-t[i]));function Tg(n){if(!n)return null;let{tree:t,turn_weight:e,...i}=n;return i}function SE({path:n,...t}){if(!n)return null;let{cost:e=null,waypoints:i=[]}=n,s=(t.violations??[]).length,o=n.status===void 0||n.status===null||i.length>0&&s>0?"given":n.status,a=t.result?.lower_bound??null;return{status:o,cost:e,waypoints:i,bound:a,violations:s,milliseconds:0,path:Tg(n),page:{...t,path:n}}}function Cg({planner:n,scene:t,page:e,options:i,draw:s,tell:r}){let o=t,a=0,c=0,l={scene:t,page:e},h=new Map,d=-1,u=!1,p=null,f={...i},_=(e.obstacles??[]).length>xE?1/0:0,g=SE(e),m={invalid:[],busy:!1,dragging:!1,answer:g,best:null,error:null,stopped:!1};g&&h.set(t,g);function y(F){Object.assign(m,F,{missing:Ks(o)}),r(["solved","given"].includes(m.answer?.status)?{...m,invalid:[]}:m)}function E(F,X){h.delete(F),h.set(F,X);let j=[...h.keys()].find(ot=>ot!==t);h.size>yE&&h.delete(j)}function b(F,X,j){l={scene:X,page:F};let ot=performance.now();s(F,X,j),_=performance.now()-ot}let T=()=>!o.turning&&ei.every(F=>o.query?.[F])?vE(o.query.start,o.query.goal):0;async function w(){if(!u){u=!0;try{for(;d!==a;)await x()}catch{d=a,y({invalid:[]})}finally{u=!1}}}async function x(){let[F,X]=[a,o],{place:j}=await n.ready(),ot=[],$=Xc(X).length>1&&!X.query?.orientation;for(let R of $?[]:ei){let z=X.query?.[R],it=e[`${R}_orientation`],ht=z&&await j.ask({ask:"place",scene:X,at:z,orientation:it});if(ht===null)return;ht?.violation&&ot.push({end:R,...ht})}d=F,(!m.answer||F===a)&&y({invalid:ot})}function M(F){c=a,b(F.page,o,!0),y({answer:F,busy:!1,best:null,error:null,stopped:!1})}async function D(){let[F,X]=[a,o],{plan:j}=await n.ready();if(p)return;let ot=Tg(l.page.path),$=ot?.waypoints.length>1?ot:void 0,R={...f,gap:void 0,post:void 0,settings:void 0,..._E},z={ask:"plan",scene:X,options:R,path:$,page:!0,extras:!1},it=null;try{it=await j.ask(z)}catch(rt){F===a&&y({error:rt.message})}if(!it||F<=c)return;if(it.waypoints.length===0){F===a&&y({best:null});return}c=F,_<=Eg&&b(it.page,X,F===a);let ht=it.page.result?.lower_bound??null;y({best:{cost:it.cost,bound:ht,straight:T(),of:X},error:null})}function P({cost:F,waypoints:X}){let j=m.best?.cost??1/0;if(!(F<j)||(y({best:{cost:F,straight:T(),waypoints:X,of:o}}),_>Eg))return;let{path:ot,motion:$}=l.page,R={...ot,status:"solved",orientations:void 0,waypoints:X,raw_waypoints:[],cost:F,raw_cost:null,tree:null};b({...$c(o,l.page,l.scene),path:R,motion:$},o,"path")}async function O(){p&&(p=null,(await n.ready()).plan.cancel())}async function B(F,X,j){let{plan:ot}=await n.ready();if(F!==a)return null;let $={};p=$;let z={ask:"plan",scene:X,options:{...f,...j===void 0?{}:{budget_ms:j}},page:!0,extras:!0};try{return await ot.ask(z,it=>F===a&&P(it))}finally{p===$&&(p=null)}}async function q(F){let[X,j]=[a,o];y({busy:!0,stopped:!1});try{let ot=await B(X,j,F);return ot&&E(j,ot),!ot||X!==a?co:(M(ot),ot)}catch(ot){throw X===a&&y({busy:!1,error:ot.message}),ot}}function I(){let{path:F,motion:X}=l.page;b({...$c(o,l.page,l.scene),path:F,motion:X},o,!1)}let V=F=>qc(F,[]).length;async function Y(F,{dragging:X=!1,budget:j,again:ot=!1}={}){let $=String(F.obstacles?.map(({box:it})=>it))!==String(l.scene.obstacles?.map(({box:it})=>it)),R=X||m.best?.of===F?m.best:null;a+=1,o=F,O();let z=ot?null:h.get(o);return y({dragging:X,answer:z??null,busy:!1,stopped:!1,error:null,best:R}),z?(w(),M(z),z):Ks(o).length>0?((!X||l.page.path)&&b($c(o,l.page,l.scene),o,!0),w(),gE):(($||V(o)!==V(l.scene))&&I(),w(),X?(D(),co):q(j))}async function W(){let{best:F}=m;if(a+=1,d=a,await O(),y({busy:!1,stopped:!0}),!F?.waypoints)return;let X=a,j={version:1,status:"solved",planner:f.planner,waypoints:F.waypoints,cost:F.cost},{place:ot}=await n.ready(),$=await ot.ask({ask:"page",scene:o,path:j,extras:!0});$&&X===a&&(M({status:"solved",cost:F.cost,waypoints:F.waypoints,milliseconds:0,path:j,page:$.page}),y({stopped:!0}))}async function st(){let{place:F}=await n.ready();try{return(await F.ask({ask:"toml",scene:o}))?.toml??st()}catch(X){return y({error:`not saved: ${X.message}`}),null}}return{get scene(){return o},get shownScene(){return l.scene},get options(){return f},get isSketched(){return!m.answer&&!m.busy},get answer(){return m.answer},change:Y,stop:W,setOptions:F=>{f={...f,...F},h=new Map},toml:st,check:()=>{d=-1,y({}),w()},hasMoved:F=>{let[X,j]=[o,l.scene].map(ot=>Mn(ot,F));return X!==j&&String(X)!==String(j)}}}var bE=[120,960],ME=.85,Ru=[1e3,4e3,1e4],wE=.999,Pu={revision:-1,proved:null,rough:!0,error:null},Rg=({query:{start:n,goal:t,...e}={},...i})=>({...i,orientation:e.orientation});function EE(n,t){let[e,i]=[Rg(n),Rg(t)];return[...new Set([...Object.keys(e),...Object.keys(i)])].every(s=>e[s]===i[s])}function Pg({planner:n,scene:t,draw:e,tell:i}){let s=t,r=!1,o=0,[a,c]=bE,l=!1,h=Pu,d=null,u=0,p=()=>h.revision===o,f=()=>i({proved:h.proved,before:d,busy:u>0,error:h.error});async function _(T){let[w,x]=[o,s],{divide:M}=await n.ready(),D=T===void 0;l=D;let P=await M.ask({ask:"workspace",scene:x,budget_ms:T??a});return!P||!r||w<h.revision?null:(D&&P.decided<ME&&(a=Math.min(2*a,c)),h={revision:w,proved:Bh(P.proved),rough:D,error:null},e(h.proved),f(),w===o?P:null)}async function g(T){u+=1,f();let w=o;try{for(let x of T){let M=await _(x);if(!M||M.decided>=wE)break}}catch(x){w===o&&r&&(e(null),h={...Pu,revision:o,error:x.message})}u-=1,f()}async function m(){let{divide:T}=await n.ready();!l&&T.busy()&&T.cancel()}function y(T,{dragging:w=!1}={}){let x=EE(s,T);s=T,!(!r||x&&(w||p()&&!h.rough))&&(x||(p()&&!h.rough&&(d=h.proved.volume),o+=1,m()),g(w?[void 0]:Ru))}function E(T){if(r!==T){if(r=T,r){[h,d]=[Pu,null],g(Ru);return}e(null),m()}}async function b(T){let{divide:w}=await n.ready(),x=await w.ask({ask:"workspace",scene:s,budget_ms:T});return r&&u===0&&(!p()||h.rough)&&g(Ru),x}return{change:y,setActive:E,once:b,get isActive(){return r}}}var AE=n=>n.replace(/[^\p{L}\p{N}._-]+/gu,"_").replace(/^\.+/,"")||"scene";function Zc(n,t,e,i){let s=document.createElement("a");s.href=URL.createObjectURL(new Blob([n],{type:i})),s.download=`${AE(t)}${e}`,s.click(),setTimeout(()=>URL.revokeObjectURL(s.href),1e4)}var TE=n=>JSON.stringify(n).replace(/[<>&\u2028\u2029]/g,t=>`\\u${t.charCodeAt(0).toString(16).padStart(4,"0")}`);function Ig(){let n=document.documentElement.cloneNode(!0);return t=>(n.querySelector("#cdpr-data").textContent=TE(t),`<!doctype html>
${n.outerHTML}
`)}var lo=1e6,Iu=["anytime","two-trees","rrt-connect","modified-rrt","rrt","rrt-star"],Lg="http://www.w3.org/2000/svg",CE="M5 3 2 6l3 3M2.5 6H10a3.5 3.5 0 0 1 0 7H7",RE="M11 3l3 3-3 3M13.5 6H6a3.5 3.5 0 0 0 0 7h3",PE=[["drag","move in the floor plane"],["Shift + drag","move vertically"],["arrows at the selected thing","move along one axis"],["Alt","without the grid of 1 cm"],["N, Shift + N","select the next thing, the one before"],["\u2190 \u2192 \u2191 \u2193","1 cm along x and y"],["Page Up, Page Down, Shift + \u2191 \u2193","1 cm vertically"],["Ctrl + Z, Ctrl + Y","undo, redo"],["Delete","remove the obstacle"],["Esc","cancel the drag, or select nothing"],["touch","tap to select, then drag"]];function _e(n,t={},...e){let i=Object.assign(document.createElement(n),t);return i.append(...e),i}var wn=(n,t,e)=>{let i=_e("button",{type:"button",title:t},n);return i.addEventListener("click",e),i};function Dg(n,t,e){let i=wn("",t,e),s=document.createElementNS(Lg,"svg"),r=document.createElementNS(Lg,"path");return s.setAttribute("viewBox","0 0 16 16"),s.setAttribute("aria-hidden","true"),r.setAttribute("d",n),s.append(r),i.append(s),i.setAttribute("aria-label",t),i.classList.add("icon"),i}function Ng(n,t,e){let i=_e("select",{title:n},...t.map(([s,r])=>_e("option",{value:s},r)));return i.setAttribute("aria-label",n),i.addEventListener("change",()=>e(i.value)),i}var IE=n=>String(Math.round(n*1e4)/1e4),Jc=new WeakMap;function Og(n,t){n.value=t,n.removeAttribute("aria-invalid")}function LE(n){n.data?.includes(",")&&(n.preventDefault(),document.execCommand("insertText",!1,n.data.replaceAll(",",".")))}function Lu(n,{step:t,min:e=-lo},i){let s=_e("input",{type:"number",step:t,min:e,max:lo,inputMode:"decimal"}),r={typing:!1,text:""};return Jc.set(s,r),s.setAttribute("aria-label",n),s.addEventListener("beforeinput",LE),s.addEventListener("input",()=>{r.typing=!0}),s.addEventListener("change",()=>{let{rangeUnderflow:o,rangeOverflow:a}=s.validity,c=Number.isFinite(s.valueAsNumber)&&!o&&!a;s.setAttribute("aria-invalid",String(!c)),r.typing=!c,c&&i(s.valueAsNumber)}),s.addEventListener("blur",()=>{r.typing&&Og(s,r.text),r.typing=!1}),s}function Du(n,t){let e=Jc.get(n);e.text=IE(t),!e.typing&&Number(e.text)!==n.valueAsNumber&&Og(n,e.text)}function Ug(n,t,e){let i=_e("details",{className:"edit-menu"}),s=_e("div",{className:"edit-menu-items"},...e);i.append(_e("summary",{title:t},n),s);let r=o=>{(!i.contains(o.target)||s.contains(o.target))&&(i.open=!1)};return document.addEventListener("click",r),i}var DE=()=>_e("dl",{className:"edit-keys"},...PE.flatMap(([n,t])=>[_e("dt",{},n),_e("dd",{},t)]));function NE(n){let t=wn("scene (TOML)","the scene as a file for cdpr",()=>n.save("scene")),e=wn("path (JSON)","the path as a file for cdpr",()=>n.save("path")),i=wn("this page (HTML)","the changed page as one file",()=>n.save("page"));return{fold:Ug("save","save scene, path or page",[t,e,i]),path:e,page:i}}var OE=n=>Iu.includes(n)?Iu:[n,...Iu];function UE(n,{planner:t,orientations:e}){let i=Dg(CE,"undo (Ctrl+Z)",n.undo),s=Dg(RE,"redo (Ctrl+Shift+Z)",n.redo),r=ei.map(y=>wn(`+ ${y}`,`add a ${y}`,()=>n.addEnd(y))),o=wn("+ box","add a box",n.addBox),a=wn("remove","remove the selected obstacle (Delete)",n.remove),c=Ng("planner",OE(t).map(y=>[y,y]),n.setPlanner);c.value=t;let l=e.map(y=>[`=${y}`,y]),h=Ng("orientation",[["","best orientation"],...l],y=>n.setOrientation(y===""?null:y.slice(1)));h.hidden=e.length<2;let d=Lu("clearance, m",{step:"0.005",min:"0"},n.setClearance),u=_e("label",{className:"edit-field",title:"least distance between bodies"},"clearance",d,"m"),p=wn("workspace","prove where the platform can be, and again after every change",n.toggleVolume);p.setAttribute("aria-pressed","false");let f=NE(n),_=Ug("?","keys",[DE()]);_.firstChild.setAttribute("aria-label","keys of the editor");let g=(...y)=>_e("div",{className:"edit-group"},...y);return{box:_e("div",{className:"edit-tools"},g(i,s),g(...r,o,a),g(c,h),g(u,p),g(f.fold,_)),undo:i,redo:s,ends:r,remove:a,planners:c,turned:h,clearance:d,volume:p,save:f}}var FE="nothing selected: press start, goal, an obstacle or an outlet",BE="nothing can be selected without the 3D view; scripts move things with cdpr.move and cdpr.plan";function zE(n,{isDrawn:t}){let e=_e("strong",{className:"edit-name"}),i=["x","y","z"].map((h,d)=>Lu(`${h}, m`,{step:"0.01"},u=>n.setCoordinate(d,u))),s=i.map((h,d)=>_e("label",{className:"edit-field"},"xyz"[d],h)),r=["width","depth","height"].map((h,d)=>Lu(`${h}, m`,{step:"0.01",min:"0.001"},u=>n.setSide(d,u))),o=_e("span",{className:"edit-size"},"size",...r,"m"),a=_e("div",{className:"edit-thing"},e,...s,_e("span",{className:"edit-unit"},"m"),o),c=null;return{box:a,show:(h,d,u)=>{if(!Wn(h,c))for(let p of[...i,...r])Jc.get(p).typing=!1;if(c=h,a.classList.toggle("none",!h),!h){e.textContent=t?FE:BE,e.title="";return}e.textContent=h.name,e.title=h.name,i.forEach((p,f)=>Du(p,d[f])),o.hidden=!u,u&&r.forEach((p,f)=>Du(p,u[f]))}}}var Fg=(n,t)=>[In(n),kc(n,t)].filter(Boolean).join(" \xB7 ");function kE({page:n}){let e=(n?.no_path?.culprits??[]).slice(0,4).map(i=>Ys(i.map(String))).join("; ");return e?`no path (proved): closed by ${e}`:"no path (proved)"}function GE({waypoints:n,violations:t}){return n.length===0?"no path":`${t>0?`this path is not valid (${zc(t,t)}); it`:"this path"} stays until something changes`}var VE={given:GE,solved:({cost:n,bound:t,path:e,waypoints:i})=>Fg(n,{bound:t??e?.lower_bound,straight:e?.orientations?0:HE(i)}),no_path:kE,budget_spent:()=>"no path found in time; this is no proof that there is none",start_invalid:()=>"the start is not valid",goal_invalid:()=>"the goal is not valid"};function HE(n){let[t,e]=[n[0],n.at(-1)];return t&&e?Math.hypot(...t.map((i,s)=>i-e[s])):0}function WE({missing:n,invalid:t,busy:e,dragging:i,answer:s,best:r,error:o,stopped:a}){if(o)return{kind:"bad",text:o};if(t.length>0)return{kind:"bad",text:t.map(({end:l,violation:h})=>`${l} not valid: ${pm(h)}`).join("; ")};if(s){let l=VE[s.status]?.(s)??s.status;return{kind:{solved:"good",given:s.violations>0?"bad":""}[s.status]??"bad",text:a?`${l} (stopped)`:l}}if(n.length>0)return{kind:"",text:`add a ${n.join(" and a ")} to plan a path`};let c=r?Fg(r.cost,r):"";return a?{kind:"",text:"stopped before a path was found"}:e?{kind:"busy",text:c?`shorter? ${c}`:"planning"}:{kind:i?"busy":"",text:c}}function XE(n){let t=_e("span",{className:"edit-text"});t.setAttribute("role","status");let e=[],i=wn("move to the nearest valid place","",()=>n.moveToNearest(e)),s=wn("plan a new path","from start to goal, with the planner chosen above",n.planAnew);i.hidden=!0,s.hidden=!0;let r=wn("stop","stop planning; the best path so far stays",n.stop),o=_e("div",{className:"edit-bar"});o.setAttribute("aria-hidden","true"),r.classList.add("edit-stop");let a=_e("div",{className:"edit-status"},t,i,s,r,o);return{box:a,show:l=>{let{kind:h,text:d}=WE(l);e=l.invalid,a.dataset.kind=h,t.textContent=d,i.hidden=l.dragging||!l.invalid.some(u=>u.nearest),s.hidden=l.answer?.status!=="given"||l.missing.length>0,a.classList.toggle("busy",l.busy)}}}function qE(){let n=_e("span",{className:"edit-proved"});n.setAttribute("role","status");let t=_e("div",{className:"edit-volume"},n);return t.hidden=!0,{box:t,show:({proved:i,before:s,busy:r,error:o})=>{let a=i?rm(i,s):"proving where the platform can be";n.textContent=o??a,t.title=i?Uc(i).join(`
`):"",t.dataset.kind=o?"bad":"",t.classList.toggle("busy",r)}}}function Bg(n,t){let e=wn("Edit","edit the scene (key E)",n.toggle);e.id="edit-toggle";let i=document.getElementById("tools");if(!t.isDrawn){for(let u of i.children)u.hidden=!0;i.hidden=!1}i.prepend(_e("div",{className:"tool-group"},e));let s=wn("Done","stop editing (key E)",n.toggle);s.className="edit-done";let r=UE(n,t),o=zE(n,t),a=qE(),c=XE(n),l=_e("div",{className:"edit-head"},s,r.box),h=_e("section",{id:"edit"},l,o.box,a.box,c.box);h.setAttribute("aria-label","edit"),i.after(h);function d(u){h.hidden=!u,document.documentElement.classList.toggle("editing",u),e.setAttribute("aria-pressed",String(u)),e.textContent=u?"Done":"Edit"}return d(!1),{setActive:d,showThing:o.show,showState:c.show,showVolume:a.show,setProving:u=>{a.box.hidden=!u,r.volume.setAttribute("aria-pressed",String(u))},isComplete:u=>Jc.get(u)?.typing===!1,showTools:({canUndo:u,canRedo:p,canRemove:f,canSave:_,canSavePath:g,clearance:m,orientation:y,missing:E})=>{r.ends.forEach((b,T)=>{b.hidden=!E.includes(ei[T])}),r.undo.disabled=!u,r.redo.disabled=!p,r.remove.disabled=!f,r.save.path.disabled=!g,r.save.page.disabled=!_,Du(r.clearance,m),r.turned.value=typeof y=="string"?`=${y}`:""}}}function Nu(n){let t=_e("p",{id:"edit-missing",className:"more"},n);document.getElementById("status").after(t)}function Kc({min:n,max:t,count:e},i){return{count:e,place:r=>i.point(r.map((o,a)=>n[a]+(t[a]-n[a])*o/e))}}function $E([n,t,e,i,s,r]){let o=n>>1,a=(l,h)=>{let d=[0,0,0];return d[o]=t,d[(o+1)%3]=l,d[(o+2)%3]=h,d},c=[a(e,s),a(i,s),a(i,r),a(e,r)];return n%2===1?c:c.reverse()}function YE(n,t){let e=[],i=[];for(let r of n){let o=[0,0,0];o[r[0]>>1]=r[0]%2===1?1:-1;let[a,c,l,h]=$E(r).map(d=>t(d).toArray());for(let d of[a,c,l,a,l,h])e.push(...d),i.push(...o)}let s=new Ae;return s.setAttribute("position",new he(e,3)),s.setAttribute("normal",new he(i,3)),s}function*ZE([n,t,e,i,s,r]){let o=n>>1,[a,c]=[(o+1)%3,(o+2)%3],l=(h,d,u)=>{let p=[0,0,0];return[p[o],p[a],p[c]]=[t,h,d],{place:p,edge:u}};for(let h=e;h<i;h+=1)for(let d of[s,r])yield l(h,d,a);for(let h=s;h<r;h+=1)for(let d of[e,i])yield l(d,h,c)}function JE(n,t,e){let i=new Map;for(let s of n)for(let{place:r,edge:o}of ZE(s)){let a=r.reduce((l,h)=>l*(t+1)+h,o),c=i.get(a);c?c.directions.push(s[0]):i.set(a,{at:r,edge:o,directions:[s[0]]})}return[...i.values()].filter(({directions:s})=>s.length===1||new Set(s).size>1).flatMap(({at:s,edge:r})=>[e(s),e(s.map((o,a)=>o+(a===r?1:0)))])}function ho(n,t,e,{count:i,place:s,theme:r}){if(n.length===0)return[];let o=YE(n,s),a=u=>r.paint(new ze({transparent:!0,opacity:e.opacity,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1,...u}),t),l=(e.solid?[{colorWrite:!1},{depthWrite:!1}]:[{depthWrite:!1}]).map(u=>new ne(o,a(u))),h=new je({transparent:!0,opacity:e.edges}),d=Sn(JE(n,i,s),h);return r.paint(d.material,`${t}Edge`),[...l,d].forEach((u,p)=>{u.renderOrder=e.order+(p>0?1:0)}),[...l,d]}var KE={opacity:.24,edges:.5,order:4,solid:!1};function Ou({proved:n},t,e){return n?ho(n.inside,"reachable",KE,{...Kc(n,t),theme:e}):[]}function zg({stage:n,theme:t},e){let i=new ee;i.name="proved",n.scene.add(i);let s=null;function r(){s?.release();for(let o of[...i.children])Zs(o)}return o=>{r(),s=t.createPainter();let a=Ou({proved:o},e,s);a.length>0&&i.add(...a),n.invalidate()}}var jE=.01,QE=4e3,tA=.12,Hg=n=>n instanceof Element&&n.closest("input, select, textarea")!==null;function eA({scene:n,options:t},e){let i=Object.fromEntries(ei.filter(s=>e[s]).map(s=>[s,e[s]]));return{scene:{...n,query:{...n.query,...i}},options:t}}var Qs=n=>Math.round(n*100)/100;function kg({key:n,shiftKey:t}){return t?{ArrowUp:[2,1],ArrowDown:[2,-1]}[n]:{...{ArrowRight:[0,1],ArrowLeft:[0,-1],ArrowUp:[1,1],ArrowDown:[1,-1]},PageUp:[2,1],PageDown:[2,-1]}[n]}var nA=({status:n,cost:t,waypoints:e,milliseconds:i})=>({status:n,cost:t,waypoints:e,milliseconds:i});function Wg(n,t,e,i){let s=Cu();if(s){Nu(s),rA(s);return}let{scene:r,options:o}=eA(t,e),{setting:a}=n.current(),c=Km(r),l=!1,h=null,d=0,u=null,p=wg(),f=Cg({planner:p,scene:r,page:e,options:o,draw:D,tell:q}),_=a.stage?zg(a,n.current().view.frame):()=>{},g=Pg({planner:p,scene:r,draw:_,tell:J=>b.showVolume(J)}),m=e.cables??[],y=()=>qc(f.scene,m),E=()=>e.workspace.max.map((J,vt)=>J-e.workspace.min[vt]),b=Bg({toggle:()=>re(!l),undo:st,redo:F,addEnd:z,addBox:R,remove:it,setPlanner:J=>{f.setOptions({planner:J,gap:void 0,post:void 0,settings:void 0}),Y(V(f.scene,{again:!0}))},setOrientation:J=>W(Om(f.scene,J)),setClearance:J=>W(Nm(f.scene,J)),toggleVolume:()=>Ct(!g.isActive),setCoordinate:ot,setSide:$,moveToNearest:ht,planAnew:()=>Y(V(f.scene,{again:!0})),stop:f.stop,save:rt},{planner:o.planner??"anytime",orientations:Xc(r),isDrawn:!!a.stage}),T={things:y,placeOf:J=>Mn(f.scene,J)??Mn(f.shownScene,J)??[0,0,0],shownAt:J=>Mn(f.shownScene,J)??Mn(f.scene,J),model:()=>n.current().model,frame:()=>n.current().view.frame,limits:x,isVisible:M},w=a.stage?Jm(a,T,{select:I,drag:X}):null;function x(){let{min:J,max:vt}=e.workspace;return{min:J.map((lt,Lt)=>lt-E()[Lt]/2),max:vt.map((lt,Lt)=>lt+E()[Lt]/2)}}function M({kind:J,id:vt}){let{layers:lt}=n.current().view;return J==="end"?lt.startGoal.visible:J==="outlet"?lt.outlets.visible:lt.obstacles.visible&&(lt.obstacles.parts?.[vt]?.visible??!0)}function D(J,vt,lt){let{path:Lt}=J,Yt=yu();n.show(jr(J)),yu()!==Yt&&(!Yt&&a.stage?.isTouched()&&sg(),a.stage?.resize()),P({outdated:lt!==!0,dimmed:!lt&&!!Lt}),O(),w?.refresh()}let P=J=>{vg(n.current().view.drawn,J),a.stage?.invalidate()};function O(){let{view:J,playback:vt}=n.current();if(J.drawn){for(let lt of y().filter(f.hasMoved)){let Lt=Mn(f.shownScene,lt),Yt=Mn(f.scene,lt);Lt&&Yt&&Sg({...J,model:n.current().model},lt,Lt,Yt)}vt.setDistance(vt.distance())}}function B({invalid:J}){let vt=new Set(J.flatMap(({end:lt,violation:Lt})=>[lt,...Lt.culprits]));return y().filter(({kind:lt,name:Lt})=>lt!=="outlet"&&vt.has(Lt))}function q(J){b.showState(J),(l||J.invalid.length===0)&&w?.setBad(B(J)),I()}function I(){let{scene:J}=f??{};if(!J)return;let vt=w?.selected??null,lt=vt&&Mn(J,vt),Lt=vt?.kind==="obstacle"&&lt!==null;b.showThing(l&&lt?vt:null,lt,Lt?du(J,vt.id):null);let{clearance:Yt=0,query:be}=J,U=!!f.answer?.path,nn=f.answer?.path?.waypoints.length>0,de={canUndo:c.canUndo,canRedo:c.canRedo,canRemove:Lt,canSave:U,canSavePath:nn};b.showTools({...de,clearance:Yt,orientation:be?.orientation,missing:Ks(J)})}function V(J,vt){let lt=f.change(J,vt);return g.change(J,vt),f.answer||P({outdated:!0,dimmed:!0}),O(),w?.place(),I(),lt}let Y=J=>J.catch(()=>{});function W(J,vt){return c.push(J),Y(V(J,vt))}function st(){w?.cancel()||!c.undo()||Y(V(c.present))}function F(){h||!c.redo()||Y(V(c.present))}function X(J,vt,lt){lt==="begin"&&(h={thing:J,to:vt},a.stage.setMoving(!0)),lt==="move"&&(h.to=vt,d||(d=requestAnimationFrame(()=>{d=0,h&&Y(V(js(f.scene,J,h.to),{dragging:!0}))}))),(lt==="end"||lt==="cancel")&&j(J,lt==="end")}function j(J,vt){let{to:lt}=h;cancelAnimationFrame(d),d=0,h=null,a.stage.setMoving(!1);let Lt=String(Mn(f.scene,J))===String(lt);vt?W(Lt?f.scene:js(f.scene,J,lt)):Y(V(c.present))}function ot(J,vt){let lt=w?.selected,Lt=lt&&Mn(f.scene,lt).map((Yt,be)=>be===J?vt:Yt);Lt&&W(js(f.scene,lt,Lt))}function $(J,vt){let{id:lt}=w?.selected??{},Lt=du(f.scene,lt).map((Yt,be)=>be===J?vt:Yt);W(Um(f.scene,lt,Lt))}function R(){let J=e.workspace.min.map((Yt,be)=>Qs(Yt+E()[be]/2)),vt=E().map(Yt=>Math.max(.001,Qs(tA*Yt))),{scene:lt,name:Lt}=Lm(f.scene,vt,J);W(lt),w?.select({kind:"obstacle",id:Lt,name:Lt})}function z(J){let vt=f.scene.query?.[J==="start"?"goal":"start"],lt=e.workspace.min.map((Yt,be)=>Qs(Yt+E()[be]/2)),Lt=vt?[...[0,1].map(Yt=>Qs(2*lt[Yt]-vt[Yt])),vt[2]]:lt;vt&&String(Lt)===String(vt.map(Qs))&&(Lt[0]=Qs(Lt[0]+E()[0]/10)),W(ao(f.scene,J,Lt)),w?.select({kind:"end",id:J,name:J})}function it(){let J=w?.selected;J?.kind==="obstacle"&&(w.cancel(),w.select(null),W(Dm(f.scene,J.id)))}function ht(J){let vt=J.filter(({nearest:lt})=>lt);W(vt.reduce((lt,{end:Lt,nearest:Yt})=>ao(lt,Lt,Yt),f.scene))}async function rt(J){let{title:vt="scene"}=e;if(J==="scene"){let Lt=await f.toml();Lt!==null&&Zc(Lt,vt,".toml","application/toml")}let{answer:lt}=f;if(J==="path"&&Zc(`${JSON.stringify(lt.path,null,2)}
`,vt,".path.json","application/json"),J==="page"){let Lt={...lt.page,live:{...t,scene:f.scene,options:f.options}};Zc(i(Lt),vt,".html","text/html")}}function Ct(J){b.setProving(J),g.setActive(J)}function re(J){if(l=J,b.setActive(l),w?.setActive(l),l||Ct(!1),a.stage?.resize(),I(),!l){w?.setBad([]);return}f.check(),!f.answer&&Ks(f.scene).length===0&&Y(V(f.scene))}function It(J){let vt=w?.selected,lt=kg(J);if(!vt||!lt||h)return!1;let[Lt,Yt]=lt,be=Mn(f.scene,vt).map((de,xe)=>xe===Lt?de+Yt*jE:de),U=js(f.scene,vt,be);return J.repeat&&u?.scene===c.present&&Wn(u.thing,vt)?c.replace(U):c.push(U),u={thing:vt,scene:U},Y(V(U,{dragging:J.repeat})),!0}function Kt(){let J=u?.scene===f.scene&&l&&!h&&f.isSketched;u=null,J&&Y(V(f.scene))}function oe({shiftKey:J}){if(!w||h)return!1;let vt=y().filter(M);if(vt.length===0)return!1;let lt=vt.findIndex(Yt=>Wn(Yt,w.selected)),Lt=J?lt<0?-1:lt-1:lt+1;return w.select(vt.at(Lt%vt.length)),!0}function Zt({key:J,shiftKey:vt}){let lt=J.toLowerCase();if(lt==="z")(vt?F:st)();else if(lt==="y")F();else return!1;return!0}function Re(){return w?.cancel()?!0:w?.selected?(w.select(null),!0):!1}function Ee(J){let{key:vt,target:lt}=J,Lt=(J.ctrlKey||J.metaKey)&&b.isComplete(lt);return Hg(lt)&&!(lt.type==="range"||lt.type==="checkbox"||Lt)?!1:J.ctrlKey||J.metaKey?l&&!J.altKey&&Zt(J):J.altKey?!1:vt.toLowerCase()==="e"&&!J.repeat?(re(!l),!0):!l||lt.type==="range"?!1:vt==="Escape"?Re():vt.toLowerCase()==="n"?oe(J):(vt==="Delete"||vt==="Backspace")&&w?.selected?.kind==="obstacle"?(it(),!0):It(J)}window.addEventListener("keydown",J=>{Ee(J)&&(J.preventDefault(),J.stopPropagation())},{capture:!0}),window.addEventListener("keyup",J=>kg({key:J.key})&&Kt()),window.addEventListener("blur",Kt),iA({planning:f,proving:g,history:c,apply:V,where:J=>{let vt=y().find(lt=>lt.name===J);return(vt&&w?.where(vt))??null}}),I()}function Gg(n,t){let e=Array.isArray(t)||ArrayBuffer.isView(t)?Array.from(t):[];if(!(e.length===3&&e.every(s=>Number.isFinite(s)&&Math.abs(s)<=lo)))throw new Error(`${n}: expected three numbers [x, y, z] of at most ${lo} m`);return e}function Xg(n,t,e,i){if(t!==void 0&&!(typeof t=="number"&&e(t)))throw new Error(`${n}: expected ${i}`)}var Vg=n=>Xg("budgetMs",n,t=>t>0&&t<=1e12,"a positive number of at most 1e12");function iA({planning:n,proving:t,history:e,apply:i,where:s}){let r=async(l,h)=>{l!==e.present&&e.push(l);let d=await i(l,h);return d===co?{...co}:nA(d)},o=async l=>{let{start:h,goal:d,seed:u,budgetMs:p}=l??{},f=Object.entries({start:h,goal:d}).filter(([,g])=>g!=null).map(([g,m])=>[g,Gg(g,m)]);Xg("seed",u,g=>Number.isSafeInteger(g)&&g>=0,"a whole number that is not negative"),Vg(p),u!==void 0&&n.setOptions({seed:u});let _=f.reduce((g,[m,y])=>ao(g,m,y),n.scene);return r(_,{budget:p,again:!0})},a=async(l,h)=>{let{scene:d}=n;if(!uu(d,l)){let u=oo(d).map(p=>`"${p}"`).join(", ");throw new Error(`there is no obstacle "${l}"; there ${u?`are ${u}`:"are none"}`)}return r(js(d,{kind:"obstacle",id:l},Gg("position",h)))},c=async l=>{let{budgetMs:h=QE}=l??{};Vg(h);let d=await t.once(h);if(!d)return null;let{proved:{volume:u,total:p},decided:f,milliseconds:_}=d;return{volume:u,total:p,decided:f,milliseconds:_}};window.cdpr={plan:o,move:a,workspace:c,where:s}}function sA({trajectory:n,regions:t}){return n?"The page of a timed motion only shows it. For editing, make the page of its path: cdpr view SCENE PATH -o view.html":t?.shown?"The page of forbidden regions only shows them. For editing, make the page of the scene: cdpr view SCENE -o view.html":"This page was written without the planner (--static, live=False), so it only shows its scene."}function qg(n){let t=sA(n),e=({key:i,target:s,ctrlKey:r,metaKey:o,altKey:a})=>{i.toLowerCase()!=="e"||r||o||a||Hg(s)||document.getElementById("edit-missing")||Nu(t)};window.addEventListener("keydown",e)}function rA(n){let t=async()=>{throw new Error(n)};window.cdpr={plan:t,move:t,workspace:t}}function $g(n){let t=[1/0,1/0,1/0],e=[-1/0,-1/0,-1/0];for(let i of n)for(let s=0;s<3;s+=1)t[s]=Math.min(t[s],i[s]),e[s]=Math.max(e[s],i[s]);return t[0]<=e[0]?{min:t,max:e}:null}function*oA(n){n.workspace&&(yield*[n.workspace.min,n.workspace.max]);for(let t of n.cables)yield t.outlet;for(let t of n.obstacles)for(let e of t.parts)yield*e.vertices;yield*[n.start,n.goal].filter(Boolean),n.path&&(yield*n.path.waypoints),n.path&&(yield*n.path.rawWaypoints)}function*aA(n){for(let t of n.platform)yield*t.vertices}function cA(n){let t=c=>c&&c.max.some((l,h)=>l>c.min[h]),e=$g(oA(n));if(t(e))return e;let[i,s,r]=e?e.min:[0,0,0],o=[...aA(n)].map(c=>[c[0]+i,c[1]+s,c[2]+r]),a=$g(o);return t(a)?a:{min:[i-1,s-1,r-1],max:[i+1,s+1,r+1]}}function lA({min:n,max:t}){let e=n.map((s,r)=>s+(t[r]-s)/2),i=n.map((s,r)=>(t[r]-s)/2);return{centre:e,scale:1/Math.hypot(...i)}}function Uu(n,t=null){let e=cA(n),{centre:i,scale:s}=t??lA(e),r=(o,a=new C)=>a.set((o[0]-i[0])*s,(o[1]-i[1])*s,(o[2]-i[2])*s);return{centre:i,scale:s,point:r,vector:(o,a=new C)=>a.set(o[0],o[1],o[2]).multiplyScalar(s),box:new ve(r(e.min),r(e.max))}}var hA="http://www.w3.org/2000/svg",uA={x:[1,0,0],y:[0,1,0],z:[0,0,1]},Yg=24,jc=36;function uo(n,t,e){let i=document.createElementNS(hA,n);for(let[s,r]of Object.entries(t))i.setAttribute(s,r);return e.append(i),i}function dA(n,t,e){let i=uo("g",{class:`axis axis-${n}`},t),s=uo("line",{x1:jc,y1:jc},i),r=uo("circle",{r:8},i),o=uo("text",{"text-anchor":"middle","dominant-baseline":"central"},i);return o.textContent=n,i.addEventListener("click",()=>e(n)),{group:i,place:(c,l)=>{for(let[h,d]of[["x2",c],["y2",l]])s.setAttribute(h,d.toFixed(1));for(let[h,d]of[["cx",c],["cy",l]])r.setAttribute(h,d.toFixed(1));for(let[h,d]of[["x",c],["y",l]])o.setAttribute(h,d.toFixed(1))}}}function Zg(n,t){let e=uo("svg",{viewBox:"0 0 72 72",width:72,height:72,"aria-hidden":"true"},n),i=Object.entries(uA).map(([o,a])=>({...dA(o,e,t),direction:a})),s=new C,r=null;return o=>{if(r?.equals(o.quaternion))return;r=o.quaternion.clone();let a=o.quaternion.clone().invert(),c=i.map(({direction:h,place:d})=>(s.set(...h).applyQuaternion(a),d(jc+Yg*s.x,jc-Yg*s.y),s.z)),l=i.map(({group:h},d)=>({group:h,depth:c[d]})).sort((h,d)=>h.depth-d.depth);l.some(({group:h},d)=>e.children[d]!==h)&&e.append(...l.map(({group:h})=>h))}}var fA=.38,Fu=4,pA=24,mA=[1,2,5];function zu({workspace:n}){if(!n)return null;let t=Math.max(n.max[0]-n.min[0],n.max[1]-n.min[1]);if(!(t>0)||!Number.isFinite(t))return null;if(t>=Fu&&t<=pA)return 1;let e=10**Math.floor(Math.log10(t/Fu));return e*mA.filter(i=>i*e<=t/Fu).at(-1)}function Jg(n,t,e){let i=Math.ceil(n/e-1e-9),s=Math.floor(t/e+1e-9)-i+1;return Array.from({length:Math.max(0,s)},(r,o)=>(i+o)*e)}function Kg(n,t,e){let i=zu(n);if(i===null)return[];let{min:s,max:r}=n.workspace,o=(h,d)=>t.point([h,d,s[2]],new C),a=Jg(s[0],r[0],i).flatMap(h=>[o(h,s[1]),o(h,r[1])]),c=Jg(s[1],r[1],i).flatMap(h=>[o(s[0],h),o(r[0],h)]),l=Sn([...a,...c],new je({transparent:!0,opacity:fA,depthWrite:!1}));return e.paint(l.material,"floor"),[l]}function gA(){let n=document.createElement("canvas");n.width=64,n.height=64;let t=n.getContext("2d"),e=t.createRadialGradient(32,32,4,32,32,32);return e.addColorStop(0,"rgb(255 255 255 / 100%)"),e.addColorStop(1,"rgb(255 255 255 / 0%)"),t.fillStyle=e,t.fillRect(0,0,64,64),new Yi(n)}var Bu=null;function _A(n){Bu??(Bu=gA());let t=new yn({map:Bu,transparent:!0,opacity:.5,depthWrite:!1}),e=new ne(new fi(1,1),n.paint(t,"shadow"));return e.renderOrder=-.5,e}function xA({platform:n},t){let e=n.flatMap(({vertices:r})=>r),i=r=>{let o=e.map(a=>a[r]);return o.length>0?Math.max(...o)-Math.min(...o):0},s=.05;return[0,1].map(r=>Math.max(s,1.6*i(r)*t.scale))}function jg(n,t,e){if(!n.workspace)return{objects:[],move:()=>{}};let i=[new C,new C],s=pe(i,{linewidth:1.25,dashed:!0,dashSize:.012,gapSize:.012});e.paint(s.material,"muted");let r=_A(e),[o,a]=xA(n,t);r.scale.set(o,a,1);let c=t.point(n.workspace.min).z,l=new ee;l.add(s,r);let h=new C;return{objects:[l],move:(u,p)=>{i[0].copy(u),i[1].copy(u).setZ(c),Qn(s,i),s.computeLineDistances(),r.position.copy(i[1]),h.set(1,0,0).applyQuaternion(p),r.rotation.z=Math.atan2(h.y,h.x)}}}var yA=40,vA=(n,t)=>Math.abs(n.x-t.x)<(n.x<t.x?n:t).width&&Math.abs(n.y-t.y)<(n.y<t.y?n:t).height;function SA(n){let t=[];for(let e of n){let i=()=>t.find(s=>vA(e,s));for(let s=i();s;s=i())e.y=s.y+s.height+1;t.push(e)}}var bA={x:8,y:6},MA={x:7,y:-9};function Qg(n){let t=[],e=new C;function i(h,d,u,p=""){let f=document.createElement("span");f.className=`label ${p}`,n.append(f);let _=typeof h=="function"?h:()=>h,g=p.startsWith("cable")?MA:bA;t.push({element:f,says:_,anchor:d,layer:u,aside:g,x:0,y:0,width:0,height:0})}function s(h){let d=h.says();d!==h.element.textContent&&(h.element.textContent=d,h.width=0)}function r(h,d,{width:u,height:p}){let{element:f,anchor:_,layer:g}=h;s(h),e.copy(_).project(d);let m=!g.visible||f.textContent===""||Math.abs(e.z)>1;f.hidden=m,h.x=(e.x+1)/2*u+h.aside.x,h.y=(1-e.y)/2*p+h.aside.y}function o(h){h.width===0&&({offsetWidth:h.width,offsetHeight:h.height}=h.element)}function a(h,d){for(let p of t)r(p,h,d);let u=t.filter(({element:p})=>!p.hidden);u.forEach(o),u.length<=yA&&SA(u);for(let{element:p,x:f,y:_}of u)p.style.transform=`translate(${f.toFixed(1)}px, ${_.toFixed(1)}px)`}function c(h,{clientWidth:d}){let u=h.width/d,p=h.getContext("2d");p.font=`${12*u}px system-ui, sans-serif`,p.textBaseline="top",p.fillStyle=getComputedStyle(document.documentElement).getPropertyValue("--text");for(let{element:f,x:_,y:g}of t)f.hidden||p.fillText(f.textContent,(_+5)*u,(g+2)*u);return h}function l(){t=[],n.replaceChildren()}return{add:i,clear:l,place:a,written:c}}var ku=3.5,wA=3,EA=7,AA=8;function e0(n,...t){return Object.defineProperty(n,"visible",{get:()=>t.every(e=>e()),set:()=>{}}),n}function t0(n){return n.material.depthTest=!1,n.material.transparent=!0,n.renderOrder=AA,n}function TA(n,t,e){let i=[new C,new C],s=t0(pe(i,{linewidth:wA})),r=t0(dn(i,EA));for(let h of[s,r])t.paint(h.material,"highlight");let o=null,a=e0(new ee,()=>o!==null&&o.culprits.every(e));a.add(s,r);let c=new C;return{group:a,middle:c,show:h=>{if(o=h?.ends?h:null,!o)return;o.ends.forEach((u,p)=>n.point(u,i[p])),Qn(s,i);let d=r.geometry.attributes.position;i.forEach((u,p)=>d.setXYZ(p,u.x,u.y,u.z)),d.needsUpdate=!0,c.copy(i[0]).lerp(i[1],.5)},text:()=>o?$s(o.gap):""}}function CA(n,t,{shapes:e,strands:i},s,r){let o=new ee,a=new Map,c=[],l={position:new C,rotation:Hn(n.orientation)};function h(g){let m=Pn(g),y=pe(m,{linewidth:ku});return g.length>2&&Ac(y),{mark:y,move:()=>Qn(y,m)}}function d(){let g=pe([...e.edges,...e.segments],{linewidth:ku});return{mark:g,move:()=>{g.position.copy(l.position),g.quaternion.copy(l.rotation)}}}function u(g){let{edges:m,segments:y}=bn(g.parts,E=>t.point(E));return{mark:pe([...m,...y],{linewidth:ku}),move:()=>{}}}function p(g){let m=n.cables.findIndex(E=>E.name===g),y=n.obstacles.find(E=>E.name===g);return m>=0?h(i[m]):y?u(y):d()}function f(g){if(a.has(g))return a.get(g);let m=p(g);return s.paint(m.mark.material,"violation"),m.mark.renderOrder=6,e0(m.mark,()=>c.includes(g),()=>r(g)),a.set(g,m),o.add(m.mark),m}function _(){for(let g of c)f(g).move()}return{all:o,show:g=>{c=g,_()},move:(g,m)=>{l.position.copy(g),l.rotation.copy(m),_()}}}var RA=({motion:n,result:t})=>n?.approaches.length>0||!!t?.reason;function n0(n,t,e,i){if(!RA(n))return{objects:[],gaps:[],show:()=>{},move:()=>{},see:()=>{}};let s=()=>!0,r=h=>s(h),o=CA(n,t,e,i,r),a=(n.motion?.approaches??[]).map(()=>TA(t,i,r)),c=n.motion?[]:[...new Set(n.result.reasons.flatMap(({culprits:h})=>h))];function l(h){a.forEach((d,u)=>d.show(h?.gaps[u]?.tight?h.gaps[u]:null)),o.show(h?.bad?h.culprits:c)}return l(null),{objects:[o.all,...a.map(({group:h})=>h)],gaps:a,show:l,move:o.move,see:h=>{s=h}}}function i0(n,t,e){let i=document.getElementById("print-picture");window.addEventListener("beforeprint",()=>{e(!0),i.replaceChildren(PA(n(),t()))}),window.addEventListener("afterprint",()=>{e(!1),i.replaceChildren()})}function PA(n,{left:t,right:e,top:i,bottom:s}){let r=n.width/window.innerWidth,o=document.createElement("canvas");return o.width=Math.max(1,n.width-(t+e)*r),o.height=Math.max(1,n.height-(i+s)*r),o.getContext("2d").drawImage(n,-t*r,-i*r),o}var s0={platform:{name:"platform",swatch:"solid",group:"scene"},cables:{name:"cables",swatch:"rainbow",group:"scene"},cableNames:{name:"names of cables",swatch:"letter",group:"scene"},outlets:{name:"outlets and frame",swatch:"outline",group:"scene"},obstacles:{name:"obstacles",swatch:"solid",group:"scene"},obstacleNames:{name:"names of obstacles",swatch:"letter",group:"scene"},workspace:{name:"workspace",swatch:"outline",group:"scene"},startGoal:{name:"start and goal",swatch:"ghost",group:"path"},finalPath:{name:"final path",swatch:"thick",group:"path"},rawPath:{name:"raw path",swatch:"dashed",group:"path"},detours:{name:"path without an obstacle",swatch:"thick",group:"path"},searchTree:{name:"search tree",swatch:"hair",group:"path"},nearest:{name:"least room here",swatch:"gap",group:"analysis"},violations:{name:"violations",swatch:"cross",group:"analysis"},reachable:{name:"can be reached from the start",swatch:"ghost",group:"analysis"},walls:{name:"wall that closes the way",swatch:"solid",group:"analysis"},culprits:{name:"obstacles that close the way",swatch:"outline",group:"analysis"},nearestReachable:{name:"nearest reachable position",swatch:"ghost",group:"analysis"},swept:{name:"swept by cables",swatch:"ghost",group:"analysis"},proved:{name:"proved workspace",swatch:"ghost",group:"analysis"},feasible:{name:"wrench-feasible workspace",swatch:"ramp",group:"analysis"},regions:{name:"forbidden regions",swatch:"ghost",group:"analysis"}},Gu=()=>new Ie;function Qc({name:n,swatch:t,shown:e,apply:i,parent:s}){let r=e,o={get visible(){return r},set visible(c){r=!!c,a.tick(r),i(r)}},a=hg(n,t,o,s??vu("scene"));return Object.assign(o,{fold:(c,l)=>og(c,l,a.element),below:()=>ag(a.element),note:c=>cg(c,a.element)})}function tl(n,t,e,i,s=!0,r=void 0){return n.visible=s,n.children.length===0?n:Qc({name:t,swatch:e,shown:s,apply:a=>{n.visible=a,i()},parent:r})}function r0(n,t,e,i,s){let r={};for(let o of Object.keys(s0)){let a=new ee;a.name=o;for(let p of n[o]??[])a.add(p);i.add(a);let{name:c,swatch:l,group:h}=s0[o],d=!t.includes(o),u=a.children.length>0?vu(h):void 0;r[o]=tl(a,e[o]??c,`${l} of-${o}`,s,d,u)}return r}function c0(n,t,e){if(!n?.tree)return[];let{ends:i}=n.tree,s=Array.from({length:i.length/3},(o,a)=>t.point(i.slice(3*a,3*a+3),new C)),r=Sn(s,new je({transparent:!0,opacity:.75,depthWrite:!1}));return e.paint(r.material,"tree"),r.renderOrder=4,[r]}var o0=1e-6;function IA(n,t,e){let i=e.map((o,a)=>o-t[a]),s=i.reduce((o,a)=>o+a*a,0),r=s>0?Math.min(1,Math.max(0,i.reduce((o,a,c)=>o+a*(n[c]-t[c]),0)/s)):0;return Math.hypot(...n.map((o,a)=>o-t[a]-r*i[a]))}function a0(n,t,e){let i=s=>t.slice(1).some((r,o)=>IA(s,t[o],r)<=e);return n.every(i)}function LA(n,t){let e=Math.max(...n.flatMap(i=>i.map((s,r)=>Math.abs(s-n[0][r]))));return t.length>1&&a0(n,t,o0*e)&&a0(t,n,o0*e)}function l0(n,t,e){if(!n||n.rawWaypoints.length<2||LA(n.rawWaypoints,n.waypoints))return[];let i=n.rawWaypoints.map(o=>t.point(o)),s={polygonOffset:!0,polygonOffsetFactor:2,polygonOffsetUnits:24},r=pe(Pn(i),{linewidth:2,dashed:!0,dashSize:.025,gapSize:.018,...s});return e.paint(r.material,"rawPath"),[r]}var DA=10,NA=6.5,OA=.025;function UA(n,t){let[e]=n.slice(-1),i=n[0];return n.map((s,r)=>{if(r===0||r===n.length-1)return!0;let o=Math.min(s.distanceTo(i),s.distanceTo(e))>=OA*t;return o&&(i=s),o})}function el(n,t,e,i=n?.waypoints){if(!n||n.waypoints.length===0)return[];let s=n.waypoints.map(h=>t.point(h)),r=pe(Pn(s),{linewidth:5,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:8}),o=i.map(h=>t.point(h)),a=UA(o,t.box.getSize(new C).length()),c=dn(o.filter((h,d)=>a[d]),DA),l=a.every(Boolean)?[]:[dn(o.filter((h,d)=>!a[d]),NA)];e.paint(r.material,"finalPath");for(let{material:h}of[c,...l])e.paint(h,"waypoint");return[r,c,...l]}function FA({clearance:n,required:t,margins:e,s:i},s,r){let o=c=>n[c]<t[c]||e.some(({values:l})=>l[c]<0),a=i.map(c=>r.point(s.positionAt(c)));return i.slice(1).flatMap((c,l)=>o(l)&&o(l+1)?[a[l],a[l+1]]:[])}function h0({violations:n,motion:t},e,i,s){if(n.length===0)return[];let r=pe(t?FA(t,e,i):[],{linewidth:6});s.paint(r.material,"violation");let o=n.map(l=>i.point(e.positionAt(e.placeOf(l)))),a=Xh(o,22,.7,10),c=Xh(o,22,.4,11);return s.paint(c.material,"violation"),[r,a,c]}var BA={opacity:.24,edges:.5,order:4,solid:!1},zA={opacity:.66,edges:.9,order:6,solid:!0},kA=3.5,GA=3,fo=(n,t)=>{let e=new ee;return e.name=t,n.length>0&&e.add(...n),e};function VA(n,t,{position:e,quaternion:i}){let s=$h(n,t);s.end.copy(s.arm).applyQuaternion(i).add(e);let r=Pn(s.points);s.lay(!0);let o=pe(r,{linewidth:GA});return{line:o,hang:c=>{s.lay(c),Qn(o,r)}}}function HA(n,t,e,i){let{nearest:s,culprits:r}=n.noPath,o=Vc(e,n.orientation,i,"reachableEdge");t.point(s,o.position);let a=[o.position.clone(),t.point(n.goal??s)],c=pe(a,{linewidth:2.5,dashed:!0,dashSize:.025,gapSize:.018});i.paint(c.material,"text");let l=n.cables.flatMap(u=>{let p=r.findIndex(_=>_.includes(u.name));if(p<0)return[];let f=VA(u,t,o);return i.paint(f.line.material,Ws(p)),[f]}),h=u=>l.forEach(p=>p.hang(u));return{objects:[o,c,...l.map(u=>u.line)],hang:h,place:o.position,middle:a[0].clone().lerp(a[1],.5)}}function WA(n,t,e,i){let s=bn(n.parts,l=>e.point(l)),r=pe([...s.edges,...s.segments],{linewidth:kA});i.paint(r.material,t);let o=new ze({transparent:!0,opacity:.12,depthWrite:!1}),a=new ne(Ln(s),i.paint(o,"obstacle")),c=Sn(s.edges,new je({transparent:!0,opacity:.6}));return i.paint(c.material,"obstacleEdge"),a.renderOrder=4,{outline:r,faded:fo([a,c],n.name)}}function XA(n,t){return n.culprits.map((e,i)=>{let s=Ws(i),r=fo(ho(n.walls[i],s,zA,t),"faces");return{names:e,role:s,inner:r,group:fo([r],Ys(e))}})}function qA({noPath:n,obstacles:t},e,i){let s=o=>Math.max(0,n.culprits.findIndex(a=>a.includes(o))),r=t.filter(({name:o})=>n.blocking.includes(o));return new Map(r.map(o=>[o.name,WA(o,Ws(s(o.name)),e,i)]))}function $A({without:n},t,e){let i=s=>fo(el(s,t,e),s.obstacle);return new Map(n.map(s=>[s.obstacle,i(s)]))}function u0(n,t,e,i){let{noPath:s}=n;if(!s)return null;let r={...Kc(s,t),theme:i},o=XA(s,r),a=HA(n,t,e,i),c=fo(a.objects,"nearest"),l=qA(n,t,i),h=$A(s,t,i);function d(u){for(let{inner:p,names:f}of o)p.visible=!f.includes(u);for(let[p,{outline:f,faded:_}]of l)[f.visible,_.visible]=[p!==u,p===u];for(let[p,f]of h)f.visible=p===u;c.visible=u===null}return d(null),{walls:o,hang:a.hang,leaveOut:d,contents:{reachable:ho(s.reachable,"reachable",BA,r),walls:o.map(({group:u})=>u),nearestReachable:[c],culprits:[...l.values()].flatMap(({outline:u,faded:p})=>[u,p]),detours:[...h.values()]},labels:[{text:"nearest reachable",anchor:a.place,of:c},{text:`${In(s.toGoal)} to the goal`,anchor:a.middle,of:c}]}}function d0(n,t,e,i,s){let r=n,o=0,a=!1,c=0,l=1;function h(f){let _=Number.isFinite(f)?f:0;o=Math.min(r,Math.max(0,_)),e(o)}function d(f){f!==a&&(a=f,i(a),a&&u())}function u(){o>=r&&h(0),c=performance.now(),requestAnimationFrame(p)}function p(){if(!a)return;let f=performance.now(),_=Math.max(0,(f-c)/1e3);c=Math.max(c,f),h(o+l*_*(t?1:r/8)),o>=r?d(!1):requestAnimationFrame(p)}return document.addEventListener("visibilitychange",()=>{c=performance.now()},{signal:s}),s?.addEventListener("abort",()=>{a=!1}),{length:()=>r,restart:f=>{d(!1),r=f,h(0)},distance:()=>o,playing:()=>a,setDistance:h,setSpeed:f=>{l=f},pause:()=>d(!1),toggle:()=>d(r>0&&!a)}}var YA=(n,t)=>Math.hypot(t[0]-n[0],t[1]-n[1],t[2]-n[2]),p0=(n,t,e)=>[0,1,2].map(i=>n[i]+(t[i]-n[i])*e),Vu=(n,t)=>Math.acos(Math.min(1,Math.max(-1,n.reduce((e,i,s)=>e+i*t[s],0))));function nl(n,t,e){let i=Vu(n,t);if(i<1e-6)return n;let[s,r]=[Math.sin((1-e)*i)/Math.sin(i),Math.sin(e*i)/Math.sin(i)];return n.map((o,a)=>s*o+r*t[a])}function ZA(n,t){let e=[0];for(let i=1;i<n.length;i+=1){let s=t?2*t.weight*Vu(t.orientations[i-1],t.orientations[i]):0;e.push(e[i-1]+YA(n[i-1],n[i])+s)}return e}var JA=.06;function m0({waypoints:n,turns:t},e){if(!t)return n.map(r=>({position:r,orientation:e}));let{orientations:i}=t,s=n.slice(1).flatMap((r,o)=>{let a=Math.ceil(2*Vu(i[o],i[o+1])/JA)||1;return Array.from({length:a},(c,l)=>{let h=(l+1)/a;return{position:p0(n[o],r,h),orientation:nl(i[o],i[o+1],h)}})});return[{position:n[0],orientation:i[0]},...s]}function f0(n,t){let e=0,i=n.length-1;for(;i-e>1;){let s=e+i>>1;n[s]<=t?e=s:i=s}return e}function KA(n,t){let{unit:e,inUnit:i}=ti(n);return{title:t,unit:e,ticks:n>0?Nc(i(n)):[],whole:i(n)}}function il(n,t=null){let e=ZA(n,t),i=n.length-1,s=e[i];function r(c){if(c<=0||i===0)return n[0];if(c>=s)return n[i];let l=f0(e,c);return p0(n[l],n[l+1],(c-e[l])/(e[l+1]-e[l]))}function o(c){if(!t)return null;if(c<=0||i===0)return t.orientations[0];if(c>=s)return t.orientations[i];let l=f0(e,c),h=(c-e[l])/(e[l+1]-e[l]);return nl(t.orientations[l],t.orientations[l+1],h)}function a({segment:c,at:l}){return c>=i?s:e[c]+(e[c+1]-e[c])*l}return{timed:!1,length:s,axis:KA(s,t?"distance and turns":"distance"),corners:e.slice(1,-1),positionAt:r,orientationAt:o,placeOf:a,describe:c=>Zp(c,s)}}var jA=3,QA=4,tT=(n,t,e)=>[0,1,2].map(i=>n[i]+(t[i]-n[i])*e);function eT(n,t){let e=0,i=n.length-1;for(;i-e>1;){let s=e+i>>1;n[s]<=t?e=s:i=s}return e}function g0({times:n,positions:t,orientations:e,duration:i,corners:s}){function r(c){let l=eT(n,c),h=(c-n[l])/(n[l+1]-n[l]);return[l,Math.min(1,Math.max(0,h))]}function o(c){let[l,h]=r(c);return tT(t[l],t[l+1],h)}function a(c){if(!e)return null;let[l,h]=r(c);return nl(e[l],e[l+1],h)}return{timed:!0,length:i,corners:s.map(({time:c})=>c),axis:{title:"time",unit:_i.unit,ticks:Nc(i),whole:i},positionAt:o,orientationAt:a,placeOf:({time:c})=>c,describe:c=>Hp(c,i)}}var nT=n=>n.flatMap(({values:t})=>t),iT=n=>[...new Set(n)].filter(Number.isFinite),Hu=n=>n?`cable tensions (${n})`:"cable tensions";function _0(n){let{limits:t,tensionLimits:e,distribution:i,speed:s,acceleration:r,turnSpeed:o,cableSpeeds:a,tensions:c}=n,l=(p,f,_,g,m)=>{let y=_(as(nT(f)));return{name:p,series:f,axis:y,limits:iT(g),labelled:!0,far:jA,...m}},h={from:[0],reading:!0},d=t.cableSpeed===null?[]:[t.cableSpeed,-t.cableSpeed],u=[l("speed",[s],Dc,[t.speed],h),l("acceleration",[r],nu,[t.acceleration],h),...o?[l("angular speed",[o],iu,[t.turnSpeed],h)]:[],l("cable speeds",a,Dc,d,{column:"speed"})];return c.length===0?u:[...u,l(Hu(i),c,eo,e.flat(),{column:"tension"})]}function sT(n,t,e){let i=Vt("div",`piece of-limit-${n.kind}`);i.style.left=`${100*n.from/e}%`,i.style.width=`${100*(n.to-n.from)/e}%`,i.title=su(n);let s=t.indexOf(n.cable);if(s<0)return i;let r=Vt("div","piece-cable");return r.style.background=Pc(s),i.append(r),i}function rT(n,t){let e=Vt("div","corner");return e.style.left=`${100*n.time/t}%`,e.title=Xp(n),e}function oT(n,t,e){let i=new Map;for(let s of n){let r=i.get(s.kind)??{name:Oc({...s,cable:null}),time:0,cables:new Set};r.time+=s.to-s.from,t.includes(s.cable)&&r.cables.add(s.cable),i.set(s.kind,r)}return[...i].map(([s,{name:r,time:o,cables:a}])=>{let c=Vt("li","");c.append(Vt("span",`swatch solid of-limit-${s}`),Vt("span","",`${r} ${Wp(o/e)}`));let l=t.filter(h=>a.has(h)).slice(0,QA);for(let h of l){let d=Vt("span","key-cable");d.append(Ic(t.indexOf(h)),Vt("span","",h)),c.append(d)}return a.size>l.length&&c.append(Vt("span","more",`and ${a.size-l.length} more`)),c})}var aT=(n,t)=>n.find(({from:e,to:i})=>t>=e&&t<i)??n.find(({to:e})=>t===e);function x0({limiting:n,corners:t,cables:e,duration:i,limits:s},r,o){let a=Vt("figure","plot limiting"),c=Vt("figcaption","","what limits the motion"),l=Vt("output","reading");c.append(l);let{area:h,cursor:d,show:u}=Jh("strip",i,o);h.setAttribute("role","img"),h.setAttribute("aria-label",n.map(su).join("; ")||"nothing");let p=n.map(g=>sT(g,e,i));h.append(...p,...t.map(g=>rT(g,i)),d);let f=Vt("ul","key");n.length>0&&f.append(Vt("li","more","share of the time:")),f.append(...oT(n,e,i));let _=[qp(t),$p(s)].filter(Boolean);return a.append(c,h,Zh(r),f,..._.map(g=>Vt("p","more",g))),{box:a,show:g=>{u(g);let m=aT(n,g);l.textContent=m?Oc(m):"nothing"}}}var ni=n=>document.getElementById(n),cT="none: the cables cannot balance the platform anywhere on this path",lT={obstacles:"clearance to obstacles",robot:"clearance within the robot"};function hT({of:n,gap:t,required:e},i){let s=ti(as([...t,...e])),r=e.some(l=>l>0),o=t.some((l,h)=>l<e[h]),a=r||o?e.map(l=>Math.max(0,l)):null,c=l=>Math.abs(l)<no?"touching":s.format(l);return{name:lT[n]??n,series:[{at:i,values:t}],limits:[],floor:a,axis:s,from:[0],reading:!0,say:c,sayFully:$s}}function uT({s:n,lengths:t,approaches:e,tensions:i,tensionLimits:s,distribution:r,margins:o}){let a=h=>h.map(d=>({at:n,values:d})),c=ti(as(t.flat())),l=e.map(h=>hT(h,n));if(l.push({name:"cable lengths",series:a(t),limits:[],axis:c,column:"length"}),i.length>0){let h=[...new Set(s.flat())],d=eo(as(i.flat())),u=Hu(r);l.push({name:u,series:a(i),limits:h,axis:d,column:"tension",none:cT})}for(let{measure:h,unit:d,values:u}of o){let f=u.some(m=>m<0)?u.map(()=>0):null,_=`${h} margin beyond the demand`,g=Yp(as(u),d);l.push({name:_,series:a([u]),limits:[],from:[0],floor:f,axis:g,reading:!0})}return l}function dT(n,t){ni("wrench").textContent=n.map(e=>Qp(e,e.values[t])).join("; "),ni("wrench").classList.toggle("bad",n.some(({values:e})=>!(e[t]>=0)))}function fT(n,t){let e=ni("cable-table"),i=Vt("tr","");i.append(Vt("th","","cable"),...t.map(({column:r,axis:o})=>Vt("th","",`${r}, ${o.unit}`))),e.replaceChildren(i);let s=n.map(({name:r},o)=>{let a=Vt("tr",""),c=Vt("td","cable-name");c.append(Ic(o),Vt("span","",r)),Bp(a,o);let l=t.map(()=>Vt("td","number"));return a.append(c,...l),e.append(a),l});return r=>{s.forEach((o,a)=>{o.forEach((c,l)=>{c.textContent=t[l].axis.format(to(t[l].series[a],r))})})}}var y0=({points:n},t)=>{let e=n.slice(6*t,6*t+6);return e.length===6&&e.every(Number.isFinite)?[e.slice(0,3),e.slice(3)]:null},pT=(n,t,e)=>n.map((i,s)=>i.map((r,o)=>r+(t[s][o]-r)*e));function mT(n,t,[e,i],s){let{gap:r,required:o,tightest:a,pairs:c}=n,[l,h]=[y0(n,e),y0(n,i)],d=e!==i&&a[e]===a[i]&&l&&h,u=d?pT(l,h,(s-t[e])/(t[i]-t[e])):l;return{gap:d?to({at:t,values:r},s):r[e],required:o[e],culprits:c[a[e]],ends:u}}function gT(n){let t=i=>n.clearance[i]<n.required[i],e=(i,s)=>i.gap[s]-i.required[s]<=n.clearance[s]-n.required[s];return i=>{let[s,r]=Kh(n.s,i);if(dT(n.margins,s),n.approaches.length===0)return null;let o=!t(s)&&t(r)?r:s,a=t(o),c=o===s?[s,r]:[r,r],l=n.approaches.map(d=>{let u=d.of==="obstacles"||e(d,o);return{...mT(d,n.s,c,i),tight:u}}),h=l.find(({culprits:d})=>d===n.culprits[o]);return ni("nearest").textContent=Kp(h),ni("nearest").classList.toggle("bad",a),{...h,bad:a,gaps:l}}}var _T={motion:null,trajectory:null},Wu=n=>n.map(({box:t})=>t);function v0(n,t,e){let{motion:i,trajectory:s}=t.length>0?n:_T;if(ni("plots").hidden=!i&&!s,!i&&!s)return()=>null;let{axis:r,length:o,corners:a}=t,c={...r,length:o,corners:a,marks:n.violations.map(t.placeOf)},l=m=>zp(m,c,e),h=i?uT(i):[],d=s?_0(s):[],u=[...d,...h].map(l),p=s?d.length:u.length,f=s?[x0(s,c,e)]:[];ni("plot-list").replaceChildren(...Wu(u.slice(0,p)),...Wu(f)),ni("more-plots").replaceChildren(...Wu(u.slice(p)));let _=fT(n.cables,[...h,...d].filter(({column:m})=>m)),g=i?gT(i):()=>null;return s&&(ni("plots-title").textContent="over time"),ni("plots").classList.toggle("timed",!!s),m=>{for(let{show:y}of[...u,...f])y(m);return _(m),g(m)}}var xT=.24;function yT(n,t,e){let i=new ze({transparent:!0,opacity:xT,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:2,polygonOffsetUnits:4}),s=new ne(Ln(n),e.paint(i,t));return s.renderOrder=4,s}function vT(n,t,e){let i=pe(n.edges,{linewidth:1.5});return e.paint(i.material,t),i}function ST(n,t,e,i){let s=dn([e.point(n.outlet)],14);return i.paint(s.material,t),s.renderOrder=5,s}function bT(n,t){return n?`region${t.cables.indexOf(n)%Bi}`:"platform"}function S0(n,t,e){if(!n.regions)return[];let{space:i,meshes:s}=n.regions;if(s.length===0)return[];let r=new Set(s.map(a=>a.owner)),o=n.cables.map(({name:a})=>a).filter(a=>r.has(a));return[...new Set([...o,...r])].map(a=>{let c=n.cables.find(({name:u})=>u===a),l=bT(c,n),h=new ee;h.name=a;let d=bn(s.filter(u=>u.owner===a),u=>t.point(u));return h.add(yT(d,l,e),vT(d,l,e)),c&&i==="attachment"&&h.add(ST(c,l,t,e)),{group:h,role:l}})}var b0={type:"change"},qu={type:"start"},w0={type:"end"},sl=new ui,M0=new He,MT=Math.cos(70*qr.DEG2RAD),Ne=new C,mn=2*Math.PI,ce={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Xu=1e-6,rl=class extends Fr{constructor(t,e=null){super(t,e),this.state=ce.NONE,this.target=new C,this.cursor=new C,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Li.ROTATE,MIDDLE:Li.DOLLY,RIGHT:Li.PAN},this.touches={ONE:Di.ROTATE,TWO:Di.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new C,this._lastQuaternion=new we,this._lastTargetPosition=new C,this._quat=new we().setFromUnitVectors(t.up,new C(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ns,this._sphericalDelta=new Ns,this._scale=1,this._panOffset=new C,this._rotateStart=new Ut,this._rotateEnd=new Ut,this._rotateDelta=new Ut,this._panStart=new Ut,this._panEnd=new Ut,this._panDelta=new Ut,this._dollyStart=new Ut,this._dollyEnd=new Ut,this._dollyDelta=new Ut,this._dollyDirection=new C,this._mouse=new Ut,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=ET.bind(this),this._onPointerDown=wT.bind(this),this._onPointerUp=AT.bind(this),this._onContextMenu=DT.bind(this),this._onMouseWheel=RT.bind(this),this._onKeyDown=PT.bind(this),this._onTouchStart=IT.bind(this),this._onTouchMove=LT.bind(this),this._onMouseDown=TT.bind(this),this._onMouseMove=CT.bind(this),this._interceptControlDown=NT.bind(this),this._interceptControlUp=OT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=ce.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(b0),this.update(),this.state=ce.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Ne.copy(e).sub(this.target),Ne.applyQuaternion(this._quat),this._spherical.setFromVector3(Ne),this.autoRotate&&this.state===ce.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=mn:i>Math.PI&&(i-=mn),s<-Math.PI?s+=mn:s>Math.PI&&(s-=mn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Ne.setFromSpherical(this._spherical),Ne.applyQuaternion(this._quatInverse),e.copy(this.target).add(Ne),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Ne.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new C(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new C(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=Ne.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(sl.origin.copy(this.object.position),sl.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(sl.direction))<MT?this.object.lookAt(this.target):(M0.setFromNormalAndCoplanarPoint(this.object.up,this.target),sl.intersectPlane(M0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Xu||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Xu||this._lastTargetPosition.distanceToSquared(this.target)>Xu?(this.dispatchEvent(b0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?mn/60*this.autoRotateSpeed*t:mn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Ne.setFromMatrixColumn(e,0),Ne.multiplyScalar(-t),this._panOffset.add(Ne)}_panUp(t,e){this.screenSpacePanning===!0?Ne.setFromMatrixColumn(e,1):(Ne.setFromMatrixColumn(e,0),Ne.crossVectors(this.object.up,Ne)),Ne.multiplyScalar(t),this._panOffset.add(Ne)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Ne.copy(s).sub(this.target);let r=Ne.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(mn*this._rotateDelta.x/e.clientHeight),this._rotateUp(mn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(mn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-mn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(mn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-mn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(mn*this._rotateDelta.x/e.clientHeight),this._rotateUp(mn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Ut,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function wT(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function ET(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function AT(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(w0),this.state=ce.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function TT(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Li.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=ce.DOLLY;break;case Li.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=ce.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=ce.ROTATE}break;case Li.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=ce.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=ce.PAN}break;default:this.state=ce.NONE}this.state!==ce.NONE&&this.dispatchEvent(qu)}function CT(n){switch(this.state){case ce.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case ce.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case ce.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function RT(n){this.enabled===!1||this.enableZoom===!1||this.state!==ce.NONE||(n.preventDefault(),this.dispatchEvent(qu),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(w0))}function PT(n){this.enabled!==!1&&this._handleKeyDown(n)}function IT(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Di.ROTATE:if(this.enableRotate===!1){this.state=ce.NONE;break}this._handleTouchStartRotate(n),this.state=ce.TOUCH_ROTATE;break;case Di.PAN:if(this.enablePan===!1){this.state=ce.NONE;break}this._handleTouchStartPan(n),this.state=ce.TOUCH_PAN;break;default:this.state=ce.NONE}break;case 2:switch(this.touches.TWO){case Di.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=ce.TOUCH_DOLLY_PAN;break;case Di.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=ce.TOUCH_DOLLY_ROTATE;break;default:this.state=ce.NONE}break;default:this.state=ce.NONE}this.state!==ce.NONE&&this.dispatchEvent(qu)}function LT(n){switch(this._trackPointer(n),this.state){case ce.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case ce.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case ce.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case ce.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=ce.NONE}}function DT(n){this.enabled!==!1&&n.preventDefault()}function NT(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function OT(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var E0=new C(.45,-1,.42).normalize(),$u=.9,A0=10,UT=4,Yu={x:[1,0,0],y:[0,-1,0],z:[0,-1e-4,1]},T0={x:[-1,0,0],y:[0,1,0],z:[0,0,-1]};function R0(){try{let n=document.createElement("canvas").getContext("webgl2");return n?.getExtension("WEBGL_lose_context")?.loseContext(),n!==null}catch{return!1}}var P0=()=>Math.min(window.devicePixelRatio,2),FT=.5,BT=/swiftshader|llvmpipe|softpipe|software|basic render/i;function zT(n){let t=n.getParameter(n.RENDERER),e=/webkit/i.test(t)?n.getExtension("WEBGL_debug_renderer_info"):null;return BT.test(e?n.getParameter(e.UNMASKED_RENDERER_WEBGL):t)}function kT(n){let t=new gc({antialias:!0});return t.setPixelRatio(P0()),t.localClippingEnabled=!0,t.domElement.tabIndex=0,t.domElement.setAttribute("role","img"),t.domElement.setAttribute("aria-label","3D view; drag to turn, right-drag to pan, wheel to zoom, arrow keys to pan, with Shift to turn"),n.append(t.domElement),t}function GT(){let n={perspective:new an(30,1,.01,20),parallel:new Ji};for(let t of Object.values(n))t.up.set(0,0,1);return n}function VT(n){let t=new ee,e=new Lr(16777215,1.9);return e.position.set(-.6,.9,1),e.target.position.set(0,0,-1),t.add(e,e.target),n.add(t,new Dr(16777215,1.5)),t}function HT(n,t){let e=new rl(n,t);return e.enableDamping=!window.matchMedia("(prefers-reduced-motion: reduce)").matches,e.dampingFactor=.15,e.zoomToCursor=!0,e.minDistance=.001,e.maxDistance=50,e.listenToKeyEvents(t),e}function WT({min:n,max:t}){let e=[];for(let i of[n.x,t.x])for(let s of[n.y,t.y])for(let r of[n.z,t.z])e.push(new C(i,s,r));return e}function C0(n,{clientWidth:t,clientHeight:e},{left:i,right:s,top:r,bottom:o}){return n.setViewOffset(t,e,(s-i)/2,(o-r)/2,t,e),{x:Math.max(.3,1-(i+s)/t),y:Math.max(.3,1-(r+o)/e)}}function XT(n,t,e,i){let s=n.getCenter(new C),r=new C().crossVectors(t,e).normalize(),o=new C().crossVectors(e,r),a=WT(n).map(u=>u.sub(s)),c=(u,p)=>{let f=Math.max(...a.map(g=>g.dot(u)+g.dot(e)*p)),_=Math.min(...a.map(g=>g.dot(u)-g.dot(e)*p));return{middle:(f+_)/2,half:(f-_)/2}},l=c(r,i.x),h=c(o,i.y);return{target:s.addScaledVector(r,l.middle).addScaledVector(o,h.middle),width:l.half,height:h.half}}var qT=new Set(["platform","obstacles","cables","outlets","workspace","swept","feasible","proved","regions","reachable","walls","culprits"]),$T=2e-4;function I0(n,t){n.material&&(n.material.clippingPlanes=t);for(let e of n.children)I0(e,t)}function L0(n,t){for(let e of n.children)qT.has(e.name)?I0(e,t):e.isGroup&&e.name===""&&L0(e,t)}function D0(n,t,{margins:e,onDraw:i}){let s=t.clone(),r=new _r;r.background=new kt;let o=kT(n),a=zT(o.getContext()),c=GT(),l=VT(r),h=c.perspective,d=HT(h,o.domElement),u=[],p={width:0,height:0},f=!1,_=!1,g=new Set,m=null,y=E0,E={axis:"",fraction:.5},b=new Set;function T(){f=!1;for(let z of g)z();g.clear(),d.update();let R=h.position.distanceTo(d.target);h.near=Math.max(1e-5,R*.02),h.far=h.position.length()+10,h.isOrthographicCamera&&(h.near=-10),h.updateProjectionMatrix(),l.position.copy(h.position),l.quaternion.copy(h.quaternion),L0(r,u),o.render(r,h),i(h,p);for(let z of b)z();b.clear(),m??(m=performance.now())}function w(){f||requestAnimationFrame(T),f=!0}function x(R){let z=P0()*(R&&a?FT:1);o.getPixelRatio()!==z&&(o.setPixelRatio(z),w())}function M(R){g.add(R),w()}function D(R){b.add(R),w()}function P(R){s.copy(R),W(E.axis,E.fraction)}function O(){let R=d.enableDamping;d.enableDamping=!1,d.update(),d.enableDamping=R}function B(R){y=Yu[R]?new C(...Yu[R]).normalize():E0,h=Yu[R]?c.parallel:c.perspective,d.object=h,q()}function q(){_=!1,O();let R=C0(h,n,e()),z=n.clientWidth/n.clientHeight,it=Math.tan(c.perspective.fov*Math.PI/360)*$u,ht={x:z*R.x,y:R.y},rt=h.isOrthographicCamera,Ct={x:rt?0:it*ht.x,y:rt?0:it*ht.y},{target:re,width:It,height:Kt}=XT(s,h.up,y,Ct);d.target.copy(re);let oe=Math.max(It/ht.x,Kt/ht.y)/$u;rt&&I(oe,z),h.position.copy(re).addScaledVector(y,rt?UT:oe/(it/$u)),d.update(),w()}function I(R,z){Object.assign(h,{top:R,bottom:-R,right:R*z,left:-R*z,zoom:1})}function V(){C0(h,n,e()),h.isOrthographicCamera&&(h.right=h.top*n.clientWidth/n.clientHeight,h.left=-h.right),w()}function Y(){let{clientWidth:R,clientHeight:z}=n;R===0||z===0||(p={width:R,height:z},o.setSize(R,z),_?V():q())}function W(R,z){if(E={axis:R,fraction:z},u=[],T0[R]){let it=s.min[R]+(s.max[R]-s.min[R])*z,ht=new C(...T0[R]);u=[new He(ht,$T-it*ht[R])]}w()}function st(){T();let{domElement:R}=o,z=document.createElement("canvas");return z.width=R.width,z.height=R.height,z.getContext("2d").drawImage(R,0,0),z}function F(){let R=o.getContext(),z=performance.now();for(let Ct=0;Ct<A0;Ct+=1)T();R.readPixels(0,0,1,1,R.RGBA,R.UNSIGNED_BYTE,new Uint8Array(4));let{calls:it,triangles:ht,lines:rt}=o.info.render;return{calls:it,triangles:ht,lines:rt,frame:(performance.now()-z)/A0,firstPicture:m}}d.addEventListener("start",()=>{_=!0}),d.addEventListener("change",w),o.domElement.addEventListener("webglcontextrestored",w),new ResizeObserver(Y).observe(n),Y();let X=o.domElement;return Object.defineProperty({scene:r,controls:d,canvas:X,invalidate:w,setMoving:x,beforeNext:M,afterNext:D,setBox:P,look:B,cut:W,isCut:R=>u.some(z=>z.distanceToPoint(R)<0),isTouched:()=>_,picture:st,resize:Y,statistics:F},"camera",{get:()=>h})}function N0(n,t,e){if((n.path?.waypoints??[]).length<2)return[];let r=m0(n.path,n.orientation).map(({position:o,orientation:a})=>({at:t.point(o),turn:Hn(a)}));return n.cables.map((o,a)=>{let c=t.point(o.outlet),l=r.map(({at:f,turn:_})=>t.vector(o.attachment).applyQuaternion(_).add(f)),h=l.slice(1).flatMap((f,_)=>[c,l[_],f]),d=new Ae;d.setAttribute("position",new he(h.flatMap(f=>f.toArray()),3));let u={transparent:!0,opacity:.22,depthWrite:!1,side:ke},p=new ne(d,e.paint(new yn(u),`region${a%Bi}`));return p.renderOrder=4,p})}var ol=["#00224e","#35456c","#666970","#948e77","#c8b866","#fee838"].map(n=>new kt(n)),YT=.32;function ZT(n,t){let e=Math.min(1,Math.max(0,n))*(ol.length-1),i=Math.min(ol.length-2,Math.floor(e));return t.copy(ol[i]).lerp(ol[i+1],e-i)}function O0({feasible:n},t){if(!n)return[];let{origin:e,step:i,counts:s,margins:r,greatest:o}=n,[,a,c]=s,l=[...r.keys()].filter(_=>r[_]!==null);if(l.length===0)return[];let h=YT*i*t.scale,d=new $i(new Ti(h,h,h),new ze,l.length),u=new Jt,p=new kt,f=new C;return l.forEach((_,g)=>{let m=[Math.floor(_/c/a),Math.floor(_/c)%a,_%c];t.point(m.map((y,E)=>e[E]+y*i),f),d.setMatrixAt(g,u.makeTranslation(f.x,f.y,f.z)),d.setColorAt(g,ZT(r[_]/o,p))}),[d]}function JT({start:n,goal:t,path:e,workspace:i}){return e?.status==="goal_invalid"&&t?t:n||(i?i.min.map((s,r)=>(s+i.max[r])/2):[0,0,0])}function KT(n){if(n.trajectory)return g0(n.trajectory);let t=n.path?.waypoints??[];return t.length>0?il(t,n.path.turns):il([JT(n)])}function jT(n,t,e,i){let{start:s,goal:r,startOrientation:o,goalOrientation:a}=n;return[["start",s,o],["goal",r,a]].filter(([,l])=>l).map(([l,h,d])=>{let u=Vc(e,d,i);return u.name=l,u.position.copy(t.point(h)),u})}function QT({path:n,trajectory:t},e){return t?[0,...t.corners.map(({time:i})=>i),e.length].map(e.positionAt):n?.waypoints}var F0=12,B0=3,U0=.001;function t1(n,t,e,i,s){let r=Sm(n,e),o=bm(r,s),a=Rp(n,e,s),c=jT(n,e,r,s),l=vm(n,e,s),h=S0(n,e,s),d=n0(n,e,{shapes:r,strands:a.strands},s),u=u0(n,e,r,s),p=jg(n,e,s),f={...u?.contents,platform:[o,...p.objects],obstacles:l.objects,obstacleNames:n.obstacles.length>0?[Gu()]:[],cables:a.parts,cableNames:n.cables.length>0?[Gu()]:[],outlets:[...Mm(n,e,s),...a.wheels],searchTree:c0(n.path,e,s),rawPath:l0(n.path,e,s),finalPath:el(n.path,e,s,QT(n,t)),nearest:d.objects,violations:h0(n,t,e,s),startGoal:c,workspace:[...ym(n,e,s),...Kg(n,e,s)],swept:N0(n,e,s),feasible:O0(n,e),proved:Ou(n,e,s),regions:h.map(({group:y})=>y)},_=y=>y.position.distanceTo(o.position)<=U0&&y.quaternion.angleTo(o.quaternion)<=U0;return{contents:f,obstacles:l,ghosts:c,cables:a,highlight:d,regions:h,noPath:u,move:(y,E,b)=>{e.point(y,o.position),o.quaternion.copy(Hn(E)),a.move(o.position,o.quaternion),p.move(o.position,o.quaternion),d.move(o.position,o.quaternion),d.show(b);for(let T of c)T.visible=!_(T);i.invalidate()},hang:y=>{a.hang(y),u?.hang(y),d.move(o.position,o.quaternion),i.invalidate()}}}var e1=4,z0=n=>n.replace(/^cable\s+(?=\d+$)/i,""),n1=n=>n.length<=F0&&n.every(({name:t})=>z0(t).length<=e1),i1=n=>!!n&&Math.abs(n.rawCost-n.cost)<=1e-6*n.cost,s1=({cables:n,obstacles:t,regions:e,path:i})=>[...i1(i)?["rawPath"]:[],...n1(n)?[]:["cableNames"],"searchTree","swept","feasible",...e?.shown?[]:["regions"],...t.length>F0?["obstacleNames"]:[]];function r1({regions:n,path:t,trajectory:e}){return{...n?.meshes.every(({kind:s})=>s==="cable-obstacle")&&{regions:"shadows of obstacles"},...e&&{rawPath:"path that it follows",finalPath:"trajectory"},...t?.tree&&{searchTree:tm(t.tree)}}}function o1(n,t,e,i,s){let r=new Map,o=(c,l,h,...d)=>{r.set(c,{at:h,first:h.clone()}),e.add(l,h,...d)};for(let{name:c,parts:l}of n.obstacles){let d=new ve().setFromPoints(l.flatMap(({vertices:f})=>f.map(_=>t.point(_)))).getCenter(new C),u=i.obstacles.parts[c],p={get visible(){return i.obstacleNames.visible&&u.visible&&!s(d)}};o(`obstacle ${c}`,c,d,p)}let a=null;return Xs("names",c=>{a=c}),n.cables.forEach(({name:c,outlet:l},h)=>{let d=t.point(l),u={get visible(){return i.cableNames.visible&&!s(d)||a===h}};o(`cable ${c}`,z0(c),d,u,`cable of-${Tc(h)}`)}),r}function a1(n,t,e){let{gaps:i,see:s}=n.highlight;s(r=>e.obstacles.parts?.[r]===void 0||e.obstacles.visible&&e.obstacles.parts[r].visible);for(let{group:r,middle:o,text:a}of i)t.add(a,o,{get visible(){return!n.outdated&&e.nearest.visible&&r.visible}},"gap")}function c1({cables:n},t,e){if(!n.some(vc))return;let i=n.some(({sag:s})=>s)?"as low as they can hang":"round their pulleys";e.hanging=Qc({name:i,swatch:"part hanging of-cables",shown:!0,apply:t.hang,parent:e.cables.below()})}function l1(n,t,e,i){if(n.obstacles.length===0)return;let s=new Set,r=n.obstacles.length<=B0,o=e.obstacles.fold(r?"by name":`by name (${n.obstacles.length})`,r),a=()=>t.show(s),c=({name:l},h)=>Qc({name:l,swatch:"part solid of-obstacles",shown:!0,apply:u=>{u?s.delete(h):s.add(h),i.beforeNext(a)},parent:o});e.obstacles.parts=Object.fromEntries(n.obstacles.map((l,h)=>[l.name,c(l,h)])),r||lg(o,Object.values(e.obstacles.parts))}function h1(n,t,e,i){if(n.length===0)return;let s=t.regions.fold("by cable",e),r=({group:o,role:a})=>tl(o,o.name,`part ghost of-${a}`,i,!0,s);t.regions.parts=Object.fromEntries(n.map(o=>[o.group.name,r(o)]))}function u1({walls:n},t,e){let i=t.walls.fold("by whom",n.length<=B0),s=({group:r,role:o})=>tl(r,r.name,`part solid of-${o}`,e,!0,i);t.walls.parts=Object.fromEntries(n.map(r=>[r.group.name,s(r)]))}function d1(n,t,e){let i=null;return s=>{i!==null&&(t.obstacles.parts[i].visible=!0),s!==null&&(t.obstacles.parts[s].visible=!1),i=s,n.leaveOut(s),e()}}function f1(n,t){n.toBlob(e=>{let i=document.createElement("a");i.href=URL.createObjectURL(e),i.download=`${t.replace(/[^\p{L}\p{N}._-]+/gu,"_")}.png`,i.click(),setTimeout(()=>URL.revokeObjectURL(i.href),1e4)},"image/png")}function p1(n){let t=document.getElementById("view"),e=Qg(document.getElementById("labels")),i=Uu(n),s=()=>{},r=D0(t,i.box,{margins:Su,onDraw:(f,_)=>{e.place(f,_),s(f)}});s=Zg(document.getElementById("gizmo"),r.look);let o=qh(r.invalidate);o.createPainter().bind(r.scene.background,"background");let{look:a,cut:c,resize:l,statistics:h}=r,d=()=>e.written(r.picture(),t),u=()=>f1(d(),document.getElementById("title").textContent);i0(d,Su,o.setPrinting);let p={look:a,cut:c,resize:l,picture:d,save:u,statistics:h,toggleLook:o.toggle};return{frame:i,labels:e,stage:r,theme:o,tools:p}}function m1(){return qh(()=>{}),bu("This browser cannot draw in 3D (WebGL 2 is not available), so only the texts are shown."),{tools:{look:null}}}function g1(n){let t=i=>new Map(Object.entries(i).map(([s,{visible:r}])=>[s,r])),e=Object.entries(n).filter(([,i])=>i.parts);return{layers:t(n),parts:new Map(e.map(([i,s])=>[i,t(s.parts)]))}}function _1(n,t){let e=(i,s)=>{for(let[r,o]of Object.entries(i)){let a=s?.get(r)??o.visible;a!==o.visible&&(o.visible=a)}};e(n,t.layers);for(let[i,s]of Object.entries(n))s.parts&&e(s.parts,t.parts.get(i))}function x1(n,t,{frame:e,labels:i,stage:s,theme:r,tools:o},a){let c=Uu(n,e),l=r.createPainter(),h=new ee;a&&s.setBox(c.box);let d=rg();i.clear();let u=t1(n,t,c,s,l),{contents:p,obstacles:f,ghosts:_,regions:g,noPath:m,move:y}=u,E=r0(p,s1(n),r1(n),h,s.invalidate);c1(n,u,E),l1(n,f,E,s),h1(g,E,!!n.regions?.shown,s.invalidate),p.feasible.length>0&&E.feasible.note(em(n.feasible)),u.anchors=o1(n,c,i,E,s.isCut),a1(u,i,E),Xs("cables",x=>{u.cables.light(x),s.invalidate()}),m&&u1(m,E,s.invalidate);for(let{text:x,anchor:M,of:D}of m?.labels??[])i.add(x,M,{get visible(){return!u.outdated&&E.nearestReachable.visible&&D.visible}});let b=m?d1(m,E,s.invalidate):()=>{};for(let x of _)i.add(x.name,x.position,E.startGoal);n.result?.via.forEach((x,M)=>{let D=n.path?.waypoints[x];D&&i.add(`via ${M+1}`,c.point(D),E.finalPath)}),a&&_1(E,g1(a.layers)),d(),s.scene.add(h);let T=()=>{l.release(),h.removeFromParent(),s.afterNext(()=>Zs(h))},w=x=>Lp(s,u.cables.strands,()=>E.cables.visible,x);return dg(zu(n)),{...o,move:y,leaveOut:b,layers:E,frame:c,drawn:u,point:w,remove:T}}var y1={move:()=>{},leaveOut:()=>{},layers:{},drawn:null,point:()=>{},remove:()=>{}},v1=({workspace:n})=>n?Math.max(...[...n.min,...n.max].map(Math.abs)):1;function S1(n,t,e,i){let s=t,r=()=>null,o=v1(n),a=n.path?n.orientation:n.startOrientation,c=f=>s.orientationAt?.(f)??a,l=d0(s.length,s.timed,f=>{let _=s.positionAt(f);e.move(_,c(f),r(f)),gg(_,o),mg(f,s.length,s.describe(f))},Eu,i),h=f=>{l.pause(),l.setDistance(f)},d=f=>{let{waypoints:_}=n.noPath.without.find(({obstacle:g})=>g===f)??{};s=_?il(_):t,e.leaveOut(f),l.restart(s.length),Mu(s.length),wu(s.corners,s.length)};r=v0(n,s,h),mm(n,s.length,h),pg(l,s.timed,i),wu(s.corners,s.length),e.point(i),eg(n.noPath,d),ug(n.violations,s,h),yg(l,e,i);let u=()=>s.positionAt(l.distance()),p=()=>c(l.distance());return{playback:l,timed:s.timed,position:u,orientation:p}}function b1(n,{playback:t,timed:e,position:i,orientation:s}){let{distance:r,setDistance:o}=t,a={distance:t.distance,setDistance:t.setDistance};window.cdprViewer={get length(){return e?null:t.length()},get duration(){return e?t.length():null},...e?{time:r,setTime:o}:a,position:i,orientation:s,layers:n.layers,look:n.look,picture:n.picture??null,statistics:n.statistics??null,resetView:n.look&&(()=>n.look()),ready:!0}}function M1({playback:n}){let t=n.length();return{share:t>0?n.distance()/t:0,playing:n.playing()}}function w1(){let n=null,t=null;return{show:i=>{let s=t,{share:r,playing:o}=s?M1(s):{share:0,playing:!1};s?.session.abort();let a=new AbortController,c=KT(i);tg(i),s||(ig(),n=R0()?p1(i):m1());let l=n.stage?x1(i,c,n,s?.view):{...n.tools,...y1},h=S1(i,c,l,a.signal);!s&&l.look&&xg(l),h.playback.setDistance(r*c.length),o?h.playback.toggle():Eu(!1),s?.view.remove(),b1(l,h),t={...h,model:i,view:l,session:a,setting:n}},current:()=>t}}function E1(){let{live:n,...t}=JSON.parse(document.getElementById("cdpr-data").textContent),e=n?Ig():null,i=w1();i.show(jr(t)),n?Wg(i,n,t,e):qg(jr(t))}try{E1()}catch(n){throw bu(`The scene cannot be shown: ${n.message}`),n}})();
