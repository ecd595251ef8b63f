home
print 1
' (finally prints 1)
