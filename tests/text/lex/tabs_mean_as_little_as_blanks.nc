O1 (LEX-9: tabs between address, number and operators)
G00	X	2.	Y3. (expect moves: rapid X2 Y3)
#100	=	7	+ 1 (expect #100=8)
M30
