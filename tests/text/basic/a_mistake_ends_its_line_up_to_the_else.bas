if 0 then x=) else x=7
print x
if 0 then if 1 print 2 else print 3 else print 4
if 1 then x=(2 else print "bad" ' (expect alarm LB0002 column 13)
' (finally prints 7)
' (finally prints 4)
