O1 (section 12.4: ABS of a vacant H is 0)
G90
#100=0
#101=50.
#102=30.
G65 P9207 R25. A30.
M30
O9207
#32=1
WHILE[#32LEABS[#11]]DO1
#33=#1+360*[#32-1]/#11
X[#101+#18*COS[#33]] Y[#102+#18*SIN[#33]]
#100=#100+1
#32=#32+1
END1
M99
(finally #100=0)
(finally moves: none)
