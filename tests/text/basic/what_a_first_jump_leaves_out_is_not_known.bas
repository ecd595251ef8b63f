a=1
if a goto 100
b=5
100 print b ' (expect warning LW0001 at b)
' (finally prints 0)
