O1 (NUM-15: each word is rounded by itself)
#1=1.2345
#2=2.3456
G91 G00 X-#1 (expect moves: rapid X-1.235)
X-#2 (expect moves: rapid X-3.581)
X[#1+#2] (expect moves: rapid X-0.001)
#100=#5001 (expect #100=-0.001)
M30
