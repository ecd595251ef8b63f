O1 (section 12.4: a negative number of holes)
G90
#100=0
#101=50.
#102=30.
G65 P9207 R25. A30. H-4
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
(finally #100=4)
(finally moves: rapid X71.651 Y42.5; rapid X62.5 Y8.349; rapid X28.349 Y17.5; rapid X37.5 Y51.651)
