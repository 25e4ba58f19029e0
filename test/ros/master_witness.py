"""A ROS master that remembers who registered what."""

import threading
import xmlrpc.client
from socketserver import ThreadingMixIn
from xmlrpc.server import SimpleXMLRPCRequestHandler, SimpleXMLRPCServer

import rosgraph


class _Handler(SimpleXMLRPCRequestHandler):
    protocol_version = 'HTTP/1.1'

    def log_message(self, *_):
        pass


class _Server(ThreadingMixIn, SimpleXMLRPCServer):
    daemon_threads = True

    def handle_error(self, request, client_address):
        """A node that ends leaves its connection without farewell: nothing to print."""


class MasterWitness:
    """Passes every call on to the real master. Unlike a look at the master's state, it misses
    nothing that comes and goes. A program uses it when started with `environment`."""

    def __init__(self):
        self._server = _Server(('localhost', 0), requestHandler=_Handler, logRequests=False)
        self._server.register_instance(self)
        self._thread = threading.Thread(target=self._server.serve_forever, args=(0.02,),
                                        daemon=True)
        self._topics = {'registerPublisher': set(), 'registerSubscriber': set()}
        self._news = threading.Condition()
        self.environment = {'ROS_MASTER_URI':
                            'http://localhost:{}/'.format(self._server.server_address[1])}

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._server.shutdown()
        self._server.server_close()

    def _dispatch(self, method, arguments):
        answer = self._answer(method, arguments)
        with self._news:
            if method in self._topics:
                self._topics[method].add(arguments[1])
            self._news.notify_all()
        return answer

    def _answer(self, method, arguments):
        return getattr(xmlrpc.client.ServerProxy(rosgraph.get_master_uri()), method)(*arguments)

    def published(self):
        with self._news:
            return set(self._topics['registerPublisher'])

    def subscribed(self):
        with self._news:
            return set(self._topics['registerSubscriber'])

    def wait_for_subscriber(self, topic, timeout):
        with self._news:
            if not self._news.wait_for(lambda: topic in self._topics['registerSubscriber'],
                                       timeout):
                raise AssertionError('nobody has subscribed to ' + topic)


class MasterWithLateLink(MasterWitness):
    """A master from which the subscriber of one topic hears of the publishers late."""

    def __init__(self, topic):
        super().__init__()
        self._topic = topic
        self._held = None

    def _answer(self, method, arguments):
        if method == 'registerSubscriber' and arguments[1] == self._topic:
            self._held = arguments
            return [1, 'later', []]
        return super()._answer(method, arguments)

    def link(self):
        """Registers the subscriber, and tells it of the publishers."""
        subscriber = self._held[3]
        _, _, publishers = super()._answer('registerSubscriber', self._held)
        xmlrpc.client.ServerProxy(subscriber).publisherUpdate('/master', self._topic, publishers)
