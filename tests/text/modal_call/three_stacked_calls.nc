O1 (CALL-17, section 6.3: each macro triggers the one below it)
G90 G00
G66 P11
G66 P12
G66 P13
X1.
G67
X2.
G67
G67
M30
O11
#100=#100+1
Y[#100]
M99
O12
#101=#101+1
Y[50+#101]
Y[60+#101]
M99
O13
#102=#102+1
Z#102
Z[10+#102]
M99
(finally moves: rapid X1; rapid Z1; rapid Y51; rapid Y1; rapid Y61; rapid Y2; rapid Z11; rapid Y52; rapid Y3; rapid Y62; rapid Y4; rapid X2; rapid Y53; rapid Y5; rapid Y63; rapid Y6)
(finally #100=6, #101=3, #102=1)
