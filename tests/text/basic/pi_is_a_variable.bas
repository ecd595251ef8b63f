print pi
pi=3
print pi
' (finally prints 3.141592654)
' (finally prints 3)
