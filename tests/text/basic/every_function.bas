print sin(pi/6); cos(pi/3); tan(pi/4); atn(1)*4; atan(1)*4
print asin(1)*2; acos(0)*2; sqr(9); sqrt(2); abs(-1.5)
print int(2.7); int(-2.7); sgn(0); exp(1); log(exp(2))
print deg(pi); rad(180); atan2(1,-1); min(3,-4); max(3,-4)
' (finally prints 0.5 0.5 1 3.141592654 3.141592654)
' (finally prints 3.141592654 3.141592654 3 1.414213562 1.5)
' (finally prints 2 -3 0 2.718281828 2)
' (finally prints 180 3.141592654 2.35619449 -4 3)
