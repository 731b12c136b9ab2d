#!/usr/bin/env python3
"""Families of inputs with known edges. families.py DATA OUT makes OUT/a (for choosing) and OUT/b (held out)."""
import json, math, random, sys
R=sys.argv[1]+'/'  # the folder with rings/ and cases.ndjson
def write(path, items, seed):
    with open(path,'w') as f:
        for name,pts,edges in items:
            order=list(range(len(pts))); random.Random(f"{seed}{name}").shuffle(order)
            place={o:i for i,o in enumerate(order)}
            P=[pts[o] for o in order]
            if len(set(map(tuple,P)))<len(P): continue
            f.write(f"{name.replace(' ','_')} {len(P)} {len(edges)}\n")
            for x,y in P: f.write(f"{x!r} {y!r}\n")
            for a,b in sorted(tuple(sorted((place[a],place[b]))) for a,b in edges): f.write(f"{a} {b}\n")
def scene(curves):
    """curves: list of (points, closed) -> points, edges"""
    P,E=[],[]
    for pts,closed in curves:
        a,n=len(P),len(pts); P+=[tuple(map(float,p)) for p in pts]
        E+=[(a+i,a+i+1) for i in range(n-1)]
        if closed and n>2: E.append((a+n-1,a))
    return P,E
def rings(file,pick):
    out=[]
    for i,l in enumerate(open(R+'rings/'+file)):
        d=json.loads(l)
        if pick(i,d['name']): out.append((d['name'],*scene([(r,True) for r in d['rings']])))
    return out
def place(P,rnd):
    t=rnd.uniform(0,6.3); c,s=math.cos(t),math.sin(t)
    return [(c*x-s*y,s*x+c*y) for x,y in P]
def jit(n,j,rnd,closed=False,ends=True):
    """n+1 parameters 0..n jittered"""
    return [i+(rnd.uniform(-j,j) if (closed or 0<i<n) else 0) for i in range(n if closed else n+1)]
def item(name,curves,rnd,seed):
    P,E=scene(curves); return (name,place(P,rnd),E)
def families(seed):
    F={}
    rnd=random.Random(seed)
    def add(f,name,curves): F.setdefault(f,[]).append(item(f"{f}-{name}",curves,rnd,seed))
    # arcs
    for j in (0,.1,.2,.3):
        for n in (24,36,48,96,192):
            for deg in (240,270,300,320,340):
                step=360/n; gap=(360-deg)/step
                m=round(deg/step)
                if gap<1.3: continue
                f='ar4' if gap>=4 else 'ar1'
                a0=rnd.uniform(0,360)
                pts=[(math.cos(math.radians(a0+t*step)),math.sin(math.radians(a0+t*step))) for t in jit(m,j/2*1.0,rnd)]
                if f=='ar4' or j<=.2: add(f,f"{n}-{deg}-{j}",[(pts,False)])
    # letters C and U with other widths (thick stroke's outline is closed; here the stroke itself)
    for h in (.1,.2,.35,.5):
        for k in range(8):
            j=[0,.3][k%2]/2; dx=.9*rnd.uniform(.8,1.2); L=rnd.uniform(.6,1.2)
            path=[(L+dx*.0,1)]
            def at(s):
                # straight L, half circle radius 1, straight L
                if s<L: return (L-s,1)
                s-=L
                if s<math.pi: return (-math.sin(s),math.cos(s))
                return (s-math.pi,-1)
            total=2*L+math.pi; n=round(total/h)
            pts=[at(t*total/n) for t in jit(n,j,rnd)]
            add('let',f"{h}-{k}",[(pts,False)])
    # parallel strokes
    for fam,j in (('par',0),('paj',.15)):
        for k in range(60):
            gap=rnd.choice([1.3,1.6,2.0,2.5,3.0]); R0=rnd.uniform(8,30); bend=rnd.choice([0,1])
            curves=[]
            nstroke=rnd.choice([2,3])
            length=rnd.uniform(9,25)
            for sidx in range(nstroke):
                off=gap*sidx; n=max(6,round(length*rnd.uniform(.8,1))); sh=rnd.uniform(0,2)
                ts=[t+sh for t in jit(n,j,rnd)]
                if bend: pts=[((R0+off)*math.cos(t/(R0+off)),(R0+off)*math.sin(t/(R0+off))) for t in ts]
                else: pts=[(t,off+.4*math.sin(t/length*6)) for t in ts]
                curves.append((pts,False))
            add(fam,f"{k}-{gap}",curves)
    # in line
    for k in range(60):
        g=rnd.choice([4,5,6,8,12,25,50,100,200]); j=rnd.choice([0,.1,.2])/2
        n1,n2=rnd.randint(6,20),rnd.randint(6,20); w=rnd.uniform(0,.6)
        def bow(x): return (x,w*math.sin(x/6))
        a=[bow(t) for t in jit(n1,j,rnd)]; b=[bow(n1+g+t) for t in jit(n2,j,rnd)]
        add('in4',f"{k}-{g}",[(a,False),(b,False)])
        g=3
        b=[bow(n1+g+t) for t in jit(n2,j,rnd)]
        add('in3',f"{k}-{g}",[(a,False),(b,False)])
    # dots
    for fam in ('do1','do2'):
        for k in range(60):
            n=rnd.choice([4,5,6]); m=rnd.choice([2,3,4,9]); sep=1 if fam=='do1' else rnd.choice([1.5,2,3])
            r=1/(2*math.sin(math.pi/n)); ap=r*math.cos(math.pi/n)
            same=rnd.random()<.5; base=rnd.uniform(0,6.3); un=rnd.choice([0,0,.15])
            curves=[]
            cols=3 if m==9 else m
            for q in range(m):
                th=base if same else rnd.uniform(0,6.3)
                d=2*(ap if (same and n!=5) else r)+sep
                cx,cy=(q%cols)*d,(q//cols)*d
                # same orientation: facing sides
                off=math.pi/n if same else 0
                th=(0 if same else th)+off
                curves.append(([(cx+r*math.cos(th+(i+rnd.uniform(-un,un))*2*math.pi/n),cy+r*math.sin(th+(i+rnd.uniform(-un,un))*2*math.pi/n)) for i in range(n)],True))
            add(fam,f"{k}-{n}-{m}-{sep}",curves)
    # concentric / near circles
    for k in range(40):
        g=rnd.choice([.8,1.0,1.3]); n=rnd.randint(14,60); r=n/(2*math.pi); r2=r+g; n2=round(2*math.pi*r2)
        j=rnd.choice([0,.2,.3])/2
        c=[]
        for rr,nn in ((r,n),(r2,n2)):
            a=rnd.uniform(0,6); c.append(([(rr*math.cos(a+t*2*math.pi/nn),rr*math.sin(a+t*2*math.pi/nn)) for t in jit(nn,j,rnd,True)],True))
        add('con',f"{k}-{g}",c)
    # smooth random closed curve (Fourier) for outliers, noise, Poisson gaps, thinned
    def blob(n,amp=.35,terms=4,j=.3):
        cs=[(rnd.gauss(0,amp/(q*1.2)),rnd.uniform(0,6.3)) for q in range(2,2+terms)]
        f=lambda t:(1+sum(a*math.cos((i+2)*t+p) for i,(a,p) in enumerate(cs)))
        M=2000
        xy=[(f(2*math.pi*i/M)*math.cos(2*math.pi*i/M),f(2*math.pi*i/M)*math.sin(2*math.pi*i/M)) for i in range(M+1)]
        acc=[0]
        for a,b in zip(xy,xy[1:]): acc.append(acc[-1]+math.dist(a,b))
        T=acc[-1]
        def at(s):
            s%=T; lo,hi=0,M
            while hi-lo>1:
                mid=(lo+hi)//2
                if acc[mid]<=s: lo=mid
                else: hi=mid
            u=(s-acc[lo])/(acc[lo+1]-acc[lo]); return (xy[lo][0]+u*(xy[lo+1][0]-xy[lo][0]),xy[lo][1]+u*(xy[lo+1][1]-xy[lo][1]))
        return T,at
    for k in range(80):
        n=rnd.randint(40,150); T,at=blob(n); h=T/n; j=rnd.choice([0,.2,.4])/2
        pts=[at(t*h) for t in jit(n,j,rnd,True)]
        share=rnd.choice([.01,.02,.05,.1]); m=max(1,round(share*n))
        xs=[p[0] for p in pts]; ys=[p[1] for p in pts]; w=max(xs)-min(xs); hh=max(ys)-min(ys)
        extra=[([(rnd.uniform(min(xs)-.05*w,max(xs)+.05*w),rnd.uniform(min(ys)-.05*hh,max(ys)+.05*hh))],False) for _ in range(m)]
        add('out',f"{k}-{share}",[(pts,True)]+extra)
    for k in range(50):
        n=rnd.randint(60,200); T,at=blob(n); h=T/n; s=rnd.choice([.1,.2])
        pts=[at(t*h) for t in jit(n,.1,rnd,True)]; pts=[(x+rnd.gauss(0,s*h),y+rnd.gauss(0,s*h)) for x,y in pts]
        add('noi',f"{k}-{s}",[(pts,True)])
    for k in range(50):
        n=rnd.randint(60,200); T,at=blob(n,.25,3)
        u=sorted(rnd.uniform(0,T) for _ in range(n))
        keep=[u[0]]
        for x in u[1:]:
            if x-keep[-1]>.15*T/n: keep.append(x)
        add('iid',f"{k}",[([at(x) for x in keep],True)])
    # worms: thin tubes about a random centre line
    for k in range(50):
        W=rnd.uniform(1.0,2.5); L=rnd.uniform(12,40); j=rnd.choice([0,.2,.3])/2
        th,x,y=rnd.uniform(0,6),0,0; cl=[]; kap=0
        ds=.1
        for i in range(int(L/ds)):
            kap+=rnd.gauss(0,.02); kap=max(-.12,min(.12,kap*.99)); th+=kap*ds; x+=ds*math.cos(th); y+=ds*math.sin(th); cl.append((x,y,th))
        left=[(x-W/2*math.sin(t),y+W/2*math.cos(t)) for x,y,t in cl]; right=[(x+W/2*math.sin(t),y-W/2*math.cos(t)) for x,y,t in cl][::-1]
        def cap(c,t0): return [(c[0]+W/2*math.cos(t0-u),c[1]+W/2*math.sin(t0-u)) for u in [math.pi*q/20 for q in range(1,20)]]
        path=left+cap(cl[-1][:2],cl[-1][2]+math.pi/2)+right+cap(cl[0][:2],cl[0][2]-math.pi/2)
        acc=[0]
        for a,b in zip(path,path[1:]+path[:1]): acc.append(acc[-1]+math.dist(a,b))
        n=round(acc[-1]); h=acc[-1]/n; ts=sorted(t*h%acc[-1] for t in jit(n,j,rnd,True)); pts=[];i=0
        q=path+path[:1]
        for t in ts:
            while acc[i+1]<t: i+=1
            u=(t-acc[i])/max(1e-12,acc[i+1]-acc[i]); pts.append((q[i][0]+u*(q[i+1][0]-q[i][0]),q[i][1]+u*(q[i+1][1]-q[i][1])))
        add('wor',f"{k}-{W:.2f}",[(pts,True)])
    # polygons: rectangles by corners (and with points between), stars, regular
    def poly(V,h):
        pts=[]
        for a,b in zip(V,V[1:]+V[:1]):
            m=max(1,round(math.dist(a,b)/h)); pts+=[(a[0]+(b[0]-a[0])*i/m,a[1]+(b[1]-a[1])*i/m) for i in range(m)]
        return pts
    for k in range(40):
        r=rnd.choice([1,1.5,2,3,4,6]); add('rec',f"{k}-{r}",[([(0,0),(r,0),(r,1),(0,1)] if k%2 else poly([(0,0),(r,0),(r,1),(0,1)],rnd.choice([.25,.34,.5,1])),True)])
    for k in range(40):
        q=rnd.choice([4,5,6,8]); inner=rnd.uniform(.35,.6); V=[]
        for i in range(2*q):
            rr=(1 if i%2==0 else inner)*rnd.uniform(.9,1.1); V.append((rr*math.cos(math.pi*i/q),rr*math.sin(math.pi*i/q)))
        side=min(math.dist(a,b) for a,b in zip(V,V[1:]))
        add('sta',f"{k}",[(poly(V,side/rnd.choice([3,4,6])),True)])
    # pads: many small rings in a grid
    for k in range(30):
        n=rnd.choice([4,6,8,12]); sep=rnd.choice([1,1.5,2,3]); cols,rows=rnd.randint(2,5),rnd.randint(1,4)
        r=1/(2*math.sin(math.pi/n)); c=[]
        for a in range(cols):
            for b in range(rows):
                d=2*r+sep; th=math.pi/n
                c.append(([(a*d+r*math.cos(th+i*2*math.pi/n),b*d+r*math.sin(th+i*2*math.pi/n)) for i in range(n)],True))
        add('pad',f"{k}-{n}-{sep}",c)
    # open curves, alone: waves and spirals, and closed near open
    for k in range(50):
        j=rnd.choice([0,.2,.4])/2; n=rnd.randint(10,80)
        if k%2: A=rnd.uniform(0,4); w=rnd.uniform(.15,.5); f=lambda t:(t,A*math.sin(w*t))
        else:
            q=rnd.uniform(1.6,3)
            f=lambda t:(lambda th:(q/6.283*th*math.cos(th),q/6.283*th*math.sin(th)))(math.sqrt(2*(t+8)*6.283/q))
        # even by arc length
        M=4000; far=n
        P=[f(far*i/M*1.0) for i in range(M+1)]; acc=[0]
        for a,b in zip(P,P[1:]): acc.append(acc[-1]+math.dist(a,b))
        m=max(6,round(acc[-1])); h=acc[-1]/m; pts=[];i=0
        for t in jit(m,j,rnd):
            t=min(max(t*h,0),acc[-1])
            while i<M-1 and acc[i+1]<t: i+=1
            u=(t-acc[i])/max(1e-12,acc[i+1]-acc[i]); pts.append((P[i][0]+u*(P[i+1][0]-P[i][0]),P[i][1]+u*(P[i+1][1]-P[i][1])))
        add('ope',f"{k}-{j}",[(pts,False)])
    # pixel borders of blobs
    for k in range(12):
        s=rnd.randint(10,40); T,at=blob(100); 
        import itertools
        M=400; ang=[at(T*i/M) for i in range(M)]
        prof=sorted((math.atan2(y,x),math.hypot(x,y)) for x,y in ang)
        def inside(i,j):
            x,y=(i-s)/s*2,(j-s)/s*2; r=math.hypot(x,y); t=math.atan2(y,x)
            lo=min(prof,key=lambda q:abs(q[0]-t)); return r<lo[1]
        g=[[inside(i,j) for j in range(2*s+1)] for i in range(2*s+1)]
        nxt={}; bad=False
        for i in range(-1,2*s+1):
            for jx in range(-1,2*s+1):
                def G(a,b): return 0<=a<=2*s and 0<=b<=2*s and g[a][b]
                if G(i,jx)!=G(i+1,jx): nxt.setdefault((i+1,jx),[]).append((i+1,jx+1)); nxt.setdefault((i+1,jx+1),[]).append((i+1,jx))
                if G(i,jx)!=G(i,jx+1): nxt.setdefault((i,jx+1),[]).append((i+1,jx+1)); nxt.setdefault((i+1,jx+1),[]).append((i,jx+1))
        if any(len(v)!=2 for v in nxt.values()): continue
        ids={p:i for i,p in enumerate(sorted(nxt))}
        E={tuple(sorted((ids[a],ids[b]))) for a in nxt for b in nxt[a]}
        F.setdefault('pix',[]).append((f"pix-{k}",[tuple(map(float,p)) for p in sorted(nxt)],sorted(E)))
    return F
if __name__=='__main__':
    import hashlib
    A,B=sys.argv[2]+'/a/',sys.argv[2]+'/b/'
    def half(name): return hashlib.md5(name.encode()).digest()[0]&1
    first=lambda i,n: i<207
    write(A+'air.txt',rings('airfoils.ndjson',lambda i,n:i<207),1); write(B+'air.txt',rings('airfoils.ndjson',lambda i,n:i>=207),1)
    write(A+'coa.txt',rings('coastlines.ndjson',lambda i,n:i%2==0),1); write(B+'coa.txt',rings('coastlines.ndjson',lambda i,n:i%2==1),1)
    for px in '48':
        f=f'mpeg7-every-{px}-px.ndjson'
        cl=sorted({json.loads(l)['name'].rsplit('-',1)[0] for l in open(R+'rings/'+f)})
        # by the parity of the number within the class
        write(A+f'mp{px}.txt',rings(f,lambda i,n:int(n.rsplit('-',1)[1])%2==0),1); write(B+f'mp{px}.txt',rings(f,lambda i,n:int(n.rsplit('-',1)[1])%2==1),1)
    cases=[json.loads(l) for l in open(R+'cases.ndjson')]
    write(A+'cas.txt',[(d['name'],[tuple(p) for p in d['points']],d['edges']) for d in cases if not d.get('options')],1)
    write(A+'cak.txt',[(d['name'],[tuple(p) for p in d['points']],d['edges']) for d in cases if d.get('options')],1)
    for path,seed in ((A,11),(B,77)):
        for f,items in families(seed).items(): write(path+f+'.txt',items,seed)
