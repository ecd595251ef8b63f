O1 (EXP-12: the return is exact)
#1=1.2345
#2=2.3456
G91 G00 X-#1 (expect moves: rapid X-1.235)
X-#2 (expect moves: rapid X-3.581)
X[ROUND[#1]+ROUND[#2]] (expect moves: rapid X0)
M30
