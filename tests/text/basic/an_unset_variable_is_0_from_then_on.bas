print a; a+1 ' (expect warning LW0001 at a)
print a
if b=0 then print "zero" ' (expect warning LW0001 at b)
' (finally prints 0 1)
' (finally prints 0)
' (finally prints zero)
' (finally a=0, b=0)
