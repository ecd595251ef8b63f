O1 (CALL-17, section 6.3: main triggers the last, that one the first)
N011 G66 P1000 X5000
N012 Z10000
N013 G66 P2000 Z6000
N014 Z15000 (expect moves: line X5 Z15 F500)
N015 G67
N016 G67
N017 Z-25000
N018 M30
O1000
#100=#100+1
N1001 G01 X#24 F500
N1002 M99
O2000
N2001 G01 Z#26 F500
N2002 Z[#26+1.]
N2003 M99
(finally #100=3)
(finally moves: rapid X0 Z10; line X5 Z10 F500; line X5 Z15; line X5 Z6; line X5 Z7; line X5 Z-25)
