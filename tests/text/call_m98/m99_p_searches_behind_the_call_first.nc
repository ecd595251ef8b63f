O1 (M99-2: of two labels the one after the call is taken)
N50 #100=#100+1
IF[#100GT1]GOTO 60
M98 P2
#101=1
N50 #102=1
N60 M30
O2
M99 P50
(finally #100=1, #101=null, #102=1)
