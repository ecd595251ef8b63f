a=1;b=2
x=a<b
if x then print "less"
y=a=b; if y then print "bad" else print "other"
print x; y
' (finally prints less)
' (finally prints other)
' (finally prints 1 0)
