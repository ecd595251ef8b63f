O1 (EXP-17: X-#1, X-[..] and X[-#1])
#1=4.
G90 G00 X-#1 (expect moves: rapid X-4)
X-[#1+1.] (expect moves: rapid X-5)
X[-#1] (expect moves: rapid X-4)
M30
